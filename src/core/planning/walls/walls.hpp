// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// One wall: loops where there is room for it on both sides, and beads as wide as the place where there is
/// not.
struct Wall {
  Regions centre_lines;        ///< of the loops
  std::vector<FillPath> thin;  ///< along the middle of narrow places, open or closed
};

/// The walls of an area and what they leave for the infill.
struct Walls {
  /// Wall 0 (outermost), 1, ...: the centre lines lie half a bead inside of the area, and for each further
  /// wall a pitch. Where less than two beads are left, a wall has thin beads instead. Fewer walls than asked
  /// for where the area is too narrow.
  std::vector<Wall> walls;
  /// What the infill has to cover.
  Regions infill;
  /// What is too narrow for lines to and fro that fit between the walls: beads along its middle.
  std::vector<FillPath> narrow_infill;
  /// Area [mm²] of what is thinner than the narrowest bead that is deposited, `walls.narrowest` pitches.
  double unprinted_mm2 = 0.0;
};

/// An area for a solid fill of lines that fit, and beads along the middle of what is too narrow for them.
struct FittedArea {
  Regions wide;
  std::vector<FillPath> narrow;
};

/// Shares out an area that a solid fill covers from border to border.
FittedArea fitted(Regions area, const PlanSettings& settings, double pitch_mm);

/// @param material  what is to be filled [mm]
/// @param pitch_mm  between neighbouring beads
/// @param contact   `Fitted` is for a solid infill only
Walls makeWalls(const Regions& material, const PlanSettings& settings, double pitch_mm, WallContact contact);

}  // namespace lamina
