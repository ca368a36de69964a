// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, TrajectorySettings& settings) {
  schema.number("trajectory.blend_tolerance_mm", settings.blend_tolerance_mm, {0.0, 10.0},
                "How far rounding may take the tip off a corner; 0 stops at corners.");
  schema.number("trajectory.blend_tolerance_deg", settings.blend_tolerance_deg, {0.0, 45.0},
                "How far rounding may turn the tool axis off what the corner asks; 0 stops at corners.");
  schema.number("trajectory.line_tolerance_mm", settings.line_tolerance_mm, Bounds::above(0.0, 10.0),
                "How far the tip may leave the straight line between two waypoints.");
  schema.number("trajectory.line_tolerance_deg", settings.line_tolerance_deg, Bounds::above(0.0, 45.0),
                "How far the tool axis may leave the steady turn between two waypoints.");
  schema.number("trajectory.joint_ramp_s", settings.joint_ramp_s, Bounds::above(0.0, 60.0),
                "Time in which a joint goes from rest to its greatest speed.");
  schema.number("trajectory.jerk_ramp_s", settings.jerk_ramp_s, {0.0, 1.0},
                "Time in which the acceleration of a joint builds up; 0 for no limit on jerk.");
}

}  // namespace lamina
