// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

/// Infill from one point to another, bead 0.4 x 0.2 mm, 30 mm/s.
inline Path straightPath(const Point3& from, const Point3& to) {
  Path path;
  path.points = {from, to};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  return path;
}

/// A closed square of 10 mm, a travel up by a layer, and a line of 10 mm.
inline Toolpath twoLayers() {
  Path wall = straightPath({0, 0, 0.2}, {10, 0, 0.2});
  wall.role = PathRole::OuterWall;
  wall.is_closed = true;
  wall.points.insert(wall.points.end(), {{10, 10, 0.2}, {0, 10, 0.2}});
  Path travel = straightPath({0, 0, 0.2}, {0, 0, 0.4});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  return {"square", {{0.2, 0.2, {wall, travel}}, {0.4, 0.2, {straightPath({0, 0, 0.4}, {10, 0, 0.4})}}}};
}

}  // namespace lamina::test
