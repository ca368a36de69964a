// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Whether a course of points comes back to its first one.
enum class Course { Open, Closed };

/// The mean of each point and of as many before as after it. Circular on a closed course, round more than
/// once if that is shorter than the window; on an open one the window shrinks evenly towards the ends, which
/// stay. Linear in the number of points, however wide the window is.
/// @param reach  points before, and after, each one
std::vector<Point3> movingAverages(const std::vector<Point3>& points, Course course, std::size_t reach);

}  // namespace lamina
