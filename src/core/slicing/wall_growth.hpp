// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/adapted_layers.hpp"
#include "slicing/wall_strand.hpp"

namespace lamina {

/// Layers that are computed in one go and divided afterwards.
struct GrowthStep {
  double height_mm = 0.0;
  std::size_t parts = 1;
};

/// The curves of one wall, layer by layer.
struct WallGrowth {
  std::vector<std::vector<AdaptedCurve>> layers;
  std::size_t completing = 0;  ///< layers at the end that complete the top
};

/// Grows one wall from its lowest level to its highest: one layer per flat contour, and then as many as the
/// top needs.
/// @param steps  one per flat contour above the lowest; less one if the highest is only the top
/// @param completing  steps that the top is completed by, coarse ones first
/// @throws Unsliceable if the top is not reached by four times the layers its distance needs; Cancelled
WallGrowth growWall(const WallStrand& strand, const std::vector<GrowthStep>& steps,
                    const std::vector<GrowthStep>& completing, Progress& progress);

}  // namespace lamina
