// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/vase.hpp"

#include <utility>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {

std::vector<FillPath> vase(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> walls;
  for (Polygon& outline : outlines(offset(regions, -0.5 * request.pitch_mm))) {
    FillPath wall;
    wall.points = std::move(outline);
    wall.is_closed = true;
    wall.role = PathRole::OuterWall;
    walls.push_back(std::move(wall));
  }
  return walls;
}

}  // namespace lamina
