// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How joints are timed along a toolpath (docs/machines/timing.md).
struct TrajectorySettings {
  /// How far rounding may take the tip off a corner; 0 stops at corners.
  double blend_tolerance_mm = 0.05;
  /// The same for the tool axis [deg]; 0 stops where the tool axis's turning changes.
  double blend_tolerance_deg = 0.5;
  /// How far the tip may leave the straight line between two waypoints.
  double line_tolerance_mm = 0.01;
  double line_tolerance_deg = 0.1;  ///< the same for the tool axis
  /// In which a joint goes from rest to its greatest speed: URDF knows no acceleration.
  double joint_ramp_s = 0.2;
  /// In which the acceleration of a joint goes from none to its greatest; 0 for no limit on jerk.
  double jerk_ramp_s = 0.0;
};

/// Adds the keys trajectory.*.
void describe(SettingsSchema& schema, TrajectorySettings& settings);

}  // namespace lamina
