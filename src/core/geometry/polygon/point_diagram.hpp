// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/polygon/voronoi.hpp>
#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

using PointDiagram = boost::polygon::voronoi_diagram<double>;

/// Computes the Voronoi diagram of points, rounded to the finest possible grid, into an empty diagram. The
/// diagram shows which points are neighbours; its vertices must be computed from the points themselves.
/// @param points  no two equal within a billionth of their extent
void construct(PointDiagram& diagram, const std::vector<Point2>& points);

/// Indices of the points around a vertex of the diagram, counter-clockwise; at least three.
std::vector<std::size_t> pointsAround(const PointDiagram::vertex_type& vertex);

}  // namespace lamina
