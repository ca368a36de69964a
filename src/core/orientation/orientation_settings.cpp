// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

void describe(SettingsSchema& schema, OrientationSettings& settings) {
  schema.choice<OrientationMode>(
      "orientation.mode", settings.mode,
      {{"layer_normal", OrientationMode::LayerNormal},
       {"fixed", OrientationMode::Fixed},
       {"wall", OrientationMode::Wall}},
      "Tool axis against the layer's normal, in one direction everywhere, or along the wall in walls.");
  const Bounds turn{-360.0, 360.0};
  schema.number("orientation.fixed_lean_deg", settings.fixed.lean_deg, {0.0, 90.0},
                "Mode fixed: lean of the nozzle from the vertical.");
  schema.number("orientation.fixed_heading_deg", settings.fixed.heading_deg, turn,
                "Mode fixed: where the nozzle leans to; 0 is x, 90 is y.");
  schema.number("orientation.wall_max_lean_deg", settings.wall.max_lean_deg, Bounds::above(0.0, 89.0),
                "Mode wall: faces that lean more from the layers' normal are no walls.");
  const Bounds lean{-60.0, 60.0};
  schema.number("orientation.lead_deg", settings.lead_deg, lean,
                "Lean of the nozzle towards where it travels.");
  schema.number("orientation.tilt_deg", settings.tilt_deg, lean,
                "Lean of the nozzle to the left of the path.");
  schema.integer("orientation.smoothing_window", settings.smoothing_window, {1, 9999},
                 "Waypoints over which the tool axis is averaged, an odd number; 1 is none.");
  schema.number("orientation.max_lean_deg", settings.limits.max_lean_deg, {0.0, 180.0},
                "Greatest angle between the tool axis and straight down; 180 is no limit.");
  schema.number("orientation.max_turn_deg_per_mm", settings.limits.max_turn_deg_per_mm, {0.0, 1000.0},
                "Greatest turn of the tool axis along a run; 0 is no limit.");
  schema.number("orientation.max_off_normal_deg", settings.limits.max_off_normal_deg, {0.0, 180.0},
                "Greatest angle between tool axis and layer's normal; a part that needs more is refused.");
  schema.number("orientation.heading_deg", settings.heading_deg, turn,
                "Heading of the nozzle's x, which does not spin about the tool axis; 0 is x, 180 is -x.");
  schema.renamed("orientation.fixed_tilt_deg", "orientation.fixed_lean_deg");
  schema.renamed("orientation.max_tilt_deg", "orientation.max_lean_deg");
}

void requireConsistent(const OrientationSettings& settings) {
  if (settings.smoothing_window < 1 || settings.smoothing_window % 2 == 0)
    throw InvalidConfig("orientation.smoothing_window is " + std::to_string(settings.smoothing_window) +
                        "; must be odd and at least 1");
  const OrientationLimits& limits = settings.limits;
  if (limits.max_turn_deg_per_mm > 0.0 && limits.max_lean_deg > 90.0 && limits.max_lean_deg < 180.0)
    throw InvalidConfig("orientation.max_lean_deg is " + numberText(limits.max_lean_deg) +
                        " deg; with orientation.max_turn_deg_per_mm it must be at most 90, or 180 for none");
}

}  // namespace lamina
