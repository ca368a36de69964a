// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls.hpp"

#include <utility>

#include "lamina/geometry/offset.hpp"

namespace lamina {

Walls makeWalls(const Regions& material, const PlanSettings& settings) {
  const double width = settings.bead.width_mm;
  Walls walls;
  for (int k = 0; k < settings.walls.count; ++k) {
    // Each wall starts from the one before, which is the same as starting from the outline but has less left
    // to do.
    Regions wall = k == 0 ? offset(material, -0.5 * width)
                          : offset(walls.centre_lines.back(), -width * (1.0 - settings.bead.overlap));
    if (wall.empty()) return walls;
    walls.centre_lines.push_back(std::move(wall));
  }
  if (settings.infill.density == 0.0) return walls;
  walls.infill = walls.centre_lines.empty()
                     ? offset(material, -0.5 * width)
                     : offset(walls.centre_lines.back(), -width * (1.0 - settings.infill.wall_overlap));
  return walls;
}

}  // namespace lamina
