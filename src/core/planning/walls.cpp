// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls.hpp"

#include <utility>

#include "lamina/geometry/offset.hpp"

namespace lamina {

Walls makeWalls(const Regions& material, const PlanSettings& settings, double pitch_mm, WallContact contact) {
  const double width = settings.bead.width_mm;
  Walls walls;
  for (int k = 0; k < settings.walls.count; ++k) {
    // Each wall starts from the one before, which is the same as starting from the outline but has less left
    // to do.
    Regions wall = k == 0 ? offset(material, -0.5 * width) : offset(walls.centre_lines.back(), -pitch_mm);
    if (wall.empty()) return walls;
    walls.centre_lines.push_back(std::move(wall));
  }
  if (settings.infill.density == 0.0) return walls;
  if (walls.centre_lines.empty()) {
    // A bead reaches beyond the width it fills: its edge, not that width, shall end at the outline.
    walls.infill = offset(material, 0.5 * (pitch_mm - width));
  } else {
    const double overlap = contact == WallContact::Overlapping ? settings.infill.wall_overlap * width : 0.0;
    walls.infill = offset(walls.centre_lines.back(), overlap - 0.5 * pitch_mm);
  }
  return walls;
}

}  // namespace lamina
