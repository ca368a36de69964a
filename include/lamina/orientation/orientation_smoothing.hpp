// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/moving_average.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Moving average of the tool axes over `window` waypoints, made unit length again [Flores2018, section
/// 6.1.2]. Circular on a closed path; on an open one the window shrinks evenly towards the ends, whose tool
/// axes stay. Where an average vanishes, as between opposite tool axes, the tool axis stays. Time is linear
/// in the waypoints.
///
/// @param window  odd; 1 changes nothing. On a closed path with fewer waypoints the window wraps around more
///   than once, and counts waypoints several times.
/// @throws InvalidConfig if it is even or not positive
std::vector<Point3> smoothedToolAxes(const std::vector<Point3>& tool_axes, Course course, int window);

}  // namespace lamina
