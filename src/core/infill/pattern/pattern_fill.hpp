// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "infill/pattern/pattern_cut.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// A pattern that covers the plane, as far as it meets a box.
using Pattern = std::function<PatternCurves(const Box2& box)>;

/// The direction in which patterns lie [rad]: that of the first layer, so that their walls stand on each
/// other.
double patternAngle(const InfillRequest& request);

/// @throws InvalidInput if the spacing is not positive, or so small that a box is more than 10 million
/// spacings
///         from the origin, or has more than 100 million squares of it
void requireSensibleSpacing(double spacing_mm, const Box2& box);

/// A sparse fill by a pattern: its curves cut where centre lines may run, with ends that follow each other
/// along the border joined along it.
/// @param step_mm  between neighbouring curves, for `longestLink`
/// @throws InvalidInput as `requireSensibleSpacing`
std::vector<FillPath> filledByPattern(const Regions& regions, const InfillRequest& request, double step_mm,
                                      const Pattern& pattern);

}  // namespace lamina
