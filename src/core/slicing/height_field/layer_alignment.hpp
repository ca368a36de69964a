// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// A place of the part's surface at which a layer should end.
struct SurfacePlace {
  double height_mm = 0.0;  ///< above the bed
  double factor = 1.0;     ///< factor on the thickness of layers at this place
};

/// Mean distance [mm] of the places from the top of the nearest layer in a stack of layers without limit; 0
/// if there are no places.
/// @param scale  by which all factors are multiplied
double distanceToTops(const std::vector<SurfacePlace>& places, double scale, const SlicingSettings& slicing);

/// Allowed range of a scale.
struct ScaleRange {
  double least = 1.0;
  double greatest = 1.0;
};

/// The scale of all factors that brings the places nearest to the tops of layers. Scales are searched that
/// move the highest place by at most half a layer; the result is 1 if no other in the allowed range is
/// better.
double alignedScale(const std::vector<SurfacePlace>& places, const ScaleRange& allowed,
                    const SlicingSettings& slicing);

}  // namespace lamina
