// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The points at which a trajectory must be cut to avoid sections whose sweep intersects itself [Vega2023,
/// section 3.1.3.4 and figure 23]: ascending indices of points, each the last of one section and the first of
/// the next.
///
/// Extrema in x or y are points strictly above, or strictly below, the points before and after them; of equal
/// consecutive points only the first counts. The ends of the trajectory are no extrema. A maximum and a
/// minimum in one coordinate, more than 3 points apart, are in conflict if they are closer than the width, or
/// if they are closer than 1.5 widths and points at most 2 from each along the path are closer than the
/// width. If there is a conflict in y, the trajectory is cut at all extrema in x; otherwise, if there is a
/// conflict in x, at all extrema in y. If it ends closer than half the width to its start, it is also cut at
/// its last but one point.
///
/// @param points    points of the trajectory in the plane of its layer [mm], at least two
/// @param width_mm  width of the bead, positive
std::vector<std::size_t> pathCuts(const std::vector<Point2>& points, double width_mm);

}  // namespace lamina
