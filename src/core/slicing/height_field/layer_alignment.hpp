// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// A place of the surface that layers are to end at.
struct SurfacePlace {
  double height_mm = 0.0;  ///< above the bed
  double factor = 1.0;     ///< by which layers are thicker there
};

/// Mean distance [mm] of the places from the nearest layer's top, layers without end; 0 for no place.
/// @param scale  of all factors
double distanceToTops(const std::vector<SurfacePlace>& places, double scale, const SlicingSettings& slicing);

/// Range of a scale.
struct ScaleRange {
  double least = 1.0;
  double greatest = 1.0;
};

/// The scale of all factors that brings the places nearest to the tops of layers; of those that change the
/// highest of them by no more than half a layer. 1 if none in the range is better.
double alignedScale(const std::vector<SurfacePlace>& places, const ScaleRange& allowed,
                    const SlicingSettings& slicing);

}  // namespace lamina
