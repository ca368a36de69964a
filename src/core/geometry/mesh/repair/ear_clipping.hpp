// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Triangulates a closed line of at least three corners by cutting off ears that are convex and empty in the
/// line's mean plane; where there is none because the line winds, the smallest corner is cut. Time grows with
/// the corners times the reflex ones among them.
std::vector<Triangle> clipEars(const std::vector<std::uint32_t>& corners,
                               const std::vector<Point3>& vertices);

}  // namespace lamina
