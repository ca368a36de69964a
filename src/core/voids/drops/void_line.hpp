// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/voids/beads/void_points.hpp"

namespace lamina {

/// Groups of points that hang together by steps no longer than `step_mm`, each by x and then y as they came,
/// the groups in the order of their first points.
std::vector<std::vector<VoidPoint>> clusters(const std::vector<VoidPoint>& points, double step_mm);

/// The points as a line: from the one farthest from their middle always on to the nearest. Of those equally
/// far the one of smaller x, then y, comes first.
std::vector<VoidPoint> guideLine(const std::vector<VoidPoint>& points, double diameter_mm);

}  // namespace lamina
