// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// The walls of an area and what they leave for the infill.
struct Walls {
  /// Centre lines of wall 0 (outermost), 1, ...: the outlines of the area shrunk by half a bead, and for each
  /// further wall by a pitch. Fewer than asked for where the area is too narrow.
  std::vector<Regions> centre_lines;
  /// What the infill has to cover.
  Regions infill;
};

/// @param material  what is to be filled [mm]
/// @param pitch_mm  between neighbouring beads
Walls makeWalls(const Regions& material, const PlanSettings& settings, double pitch_mm, WallContact contact);

}  // namespace lamina
