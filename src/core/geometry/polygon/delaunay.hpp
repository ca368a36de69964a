// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Delaunay triangles of points in the plane, counter-clockwise; of points on one circle any that fit.
/// @param points  no two the same within a billionth of their extent
std::vector<Triangle> delaunayTriangles(const std::vector<Point2>& points);

}  // namespace lamina
