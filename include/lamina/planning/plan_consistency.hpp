// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Refuses settings that contradict the infill strategy, and settings that the strategy ignores.
///
/// With drops: infill.density, unless it is 1 or the default; infill.pitch_mm, infill.bead_width_mm and
/// infill.outer_layers, unless they are 0; walls.count and skirt.count, unless they are 0 or the default;
/// voids.refill. Drops of a line, and lines of drops, must not be nearer to each other than
/// drops.most_overlap allows: otherwise every second drop is left out. With a vase: infill.density,
/// infill.pitch_mm, infill.bead_width_mm, infill.outer_layers and voids.refill unless they are the defaults,
/// and walls.count unless it is 0. With lines of a hybrid for metal: raster.direction; and hybrid.add_above
/// must not be below hybrid.delete_below.
/// @throws InvalidConfig naming key, value and what was expected; if there is no such strategy
void requireConsistent(const PlanSettings& settings);

/// @throws InvalidConfig if bead.width_mm is less than half the layer height [mm] or more than fifty times
///   the layer height, or if a width stated for infill, skins or supports is less than the layer height
void requireSensibleWidths(const PlanSettings& settings, double layer_height_mm);

/// @throws InvalidConfig if bead.pitch_mm is given and less than half or more than twice the plan width of a
///   bead in a layer of this height [mm]
void requireSensiblePitch(const BeadSettings& bead, double layer_height_mm);

}  // namespace lamina
