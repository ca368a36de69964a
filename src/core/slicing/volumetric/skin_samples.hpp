// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lamina/geometry/vector.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// Calls visit(part, middle, area) for parts of a triangle whose edges are at most `longest_mm`.
template <class Visit>
void visitParts(const std::array<Point3, 3>& corner, double longest_mm, const Visit& visit) {
  std::size_t longest = 0;
  std::array<double, 3> length{};
  for (std::size_t side = 0; side < 3; ++side) {
    length[side] = (corner[(side + 1) % 3] - corner[side]).norm();
    if (length[side] > length[longest]) longest = side;
  }
  if (length[longest] <= longest_mm) {
    const double area = 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
    return visit(corner, Point3((corner[0] + corner[1] + corner[2]) / 3.0), area);
  }
  const Point3 middle = 0.5 * (corner[longest] + corner[(longest + 1) % 3]);
  std::array<Point3, 3> part = corner;
  part[(longest + 1) % 3] = middle;
  visitParts(part, longest_mm, visit);
  part = corner;
  part[longest] = middle;
  visitParts(part, longest_mm, visit);
}

/// The node below a point of the surface, or the nearest one in the cells around it; none if there is none.
/// @param normal  of the surface at the point, outwards, of unit length
std::uint32_t nodeBelow(const CellGraph& cells, const Point3& place, const Point3& normal);

}  // namespace lamina
