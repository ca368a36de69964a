// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Direction of travel at each waypoint, of unit length [part frame]: the mean of the directions of the
/// motions that end and start there; where these are opposite, that of the motion that starts there. A motion
/// without length counts as one in the direction of the motion before it, or, at the start, after it. Empty
/// if no two points of the path differ, as with a single drop.
std::vector<Point3> pathTangents(const Path& path);

/// Length of each motion of the path [mm].
std::vector<double> motionLengths(const Path& path);

}  // namespace lamina
