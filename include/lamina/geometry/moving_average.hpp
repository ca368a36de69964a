// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Whether a sequence of points is closed, that is, its last point is followed by the first.
enum class Course { Open, Closed };

/// The moving averages of points: each is the mean over the point and `reach` points before and after it. On
/// a closed sequence the window wraps around, more than once if it is longer than the sequence. On an open
/// one it shrinks evenly towards the ends, so that the end points do not move. Time is linear in the number
/// of points, for any width of the window.
/// @param reach  number of points before, and after, each one
std::vector<Point3> movingAverages(const std::vector<Point3>& points, Course course, std::size_t reach);

}  // namespace lamina
