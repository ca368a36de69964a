// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/plan_settings.hpp"
#include "planning/travel/travel.hpp"

/// \file
/// Which travels are retracted: `travel` and `space_travel` mark them and lift the nozzle, `wipes` moves it
/// on over the bead; `program/gcode/layer_writer` writes the retraction, by `program.retraction_*`.
namespace lamina {

/// Whether a straight travel of that length is retracted: beyond the threshold; over infill only beyond
/// `comb_longest_mm`, as a combed travel of that length would ooze as much.
bool isRetracted(double distance_mm, TravelOver over, const TravelSettings& settings);

/// Whether a combed travel of that length is retracted: beyond `comb_longest_mm`.
bool isRetractedInside(double way_mm, const TravelSettings& settings);

}  // namespace lamina
