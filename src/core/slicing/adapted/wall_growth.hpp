// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "slicing/adapted/wall_strand.hpp"

namespace lamina {

/// Height of several layers that are computed in one step and divided into `parts` layers afterwards.
struct GrowthStep {
  double height_mm = 0.0;
  std::size_t parts = 1;
};

struct GrowthSteps {
  GrowthStep first;
  GrowthStep other;         ///< all other steps; their parts are as high as a layer
  double spacing_mm = 0.0;  ///< distance of points along contours
};

/// How a layer goes on from a corner of a contour.
enum class CornerPath {
  along_edge,   ///< it stays on the edge that corners of neighbouring contours lie on
  nearest_wall  ///< like any other point, beside the edge: the layer cuts the corner off
};

/// Grows one wall from its lowest flat contour to its highest, step by step. Each step grows towards the
/// lowest flat contour that is a step's height above all of the layer below, the last steps towards the top.
/// @param mesh  the part, to show the region where it cannot be sliced
/// @throws Unsliceable if a layer leaves a gap over the one below it, or the top is not reached; Cancelled
std::vector<AdaptedLayer> growWall(const Mesh& mesh, const WallStrand& strand, const GrowthSteps& steps,
                                   CornerPath corners, Progress& progress);

}  // namespace lamina
