// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Directions evenly over the half sphere z >= 0, tilted from +z by at most an angle: corners of an
/// icosahedron whose faces are divided an even number of times, which has the axes of the frame among them.
/// The fewest that are no fewer than `count` without the limit.
std::vector<Point3> sphereDirections(int count, double max_tilt_rad);

}  // namespace lamina
