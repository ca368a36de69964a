// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Where a trajectory must be cut so that no sweep along a part of it meets itself [Vega2023, section
/// 3.1.3.4 and figure 23]: indices of points, each the last of one section and the first of the next, rising.
///
/// Peaks are points strictly above both neighbours in x or y, of a level peak the first point; neither end is
/// one. Where a maximum and a minimum of y, more than 3 points apart, are nearer than the width, or are
/// nearer than 1.5 widths and any points within 2 of them along the path are nearer than the width, it is cut
/// at all peaks of x; otherwise where that is so in x, at all peaks of y. A path that ends nearer than half
/// the width to its start is cut at its last but one point.
///
/// @param points    of the trajectory in the plane of its layer, at least two
/// @param width_mm  of the bead, positive
std::vector<std::size_t> pathCuts(const std::vector<Point2>& points, double width_mm);

}  // namespace lamina
