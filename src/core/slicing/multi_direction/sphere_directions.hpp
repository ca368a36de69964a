// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Directions spread evenly over the half sphere z >= 0 and tilted from +z by at most an angle: corners of an
/// icosahedron whose faces are divided into an even number of parts along each edge, so that the axes of the
/// frame are among them. The division is the coarsest that has `count` directions on the half sphere, before
/// the limit of tilt.
std::vector<Point3> sphereDirections(int count, double max_tilt_rad);

}  // namespace lamina
