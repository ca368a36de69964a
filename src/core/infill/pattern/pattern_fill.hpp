// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "infill/pattern/pattern_cut.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// A pattern that covers the plane: returns its curves in a box.
using Pattern = std::function<PatternCurves(const Box2& box)>;

/// The direction of patterns [rad]: the direction of the first layer in all layers, so that walls stand on
/// each other.
double patternAngle(const InfillRequest& request);

/// Refuses a spacing that is not positive, or so small that the box extends to more than 10 million spacings
/// from the origin or has an area of more than 100 million squared spacings.
/// @throws InvalidInput
void requireSensibleSpacing(double spacing_mm, const Box2& box);

/// A sparse fill by a pattern: its curves are clipped to the area of centre lines, and ends that follow each
/// other along the border are joined along it.
/// @param step_mm  distance of neighbouring curves, for `longestLink`
/// @throws InvalidInput as `requireSensibleSpacing`
std::vector<FillPath> filledByPattern(const Regions& regions, const InfillRequest& request, double step_mm,
                                      const Pattern& pattern);

}  // namespace lamina
