// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/polygon/voronoi.hpp>
#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

using PointDiagram = boost::polygon::voronoi_diagram<double>;

/// Fills the empty Voronoi diagram of points, taken to a grid as fine as it can be. It reports which points
/// are neighbours; where its vertices are has to be computed from the points themselves.
/// @param points  no two the same within a billionth of their extent
void construct(PointDiagram& diagram, const std::vector<Point2>& points);

/// Numbers of the points around a vertex of the diagram, counter-clockwise; three or more.
std::vector<std::size_t> pointsAround(const PointDiagram::vertex_type& vertex);

}  // namespace lamina
