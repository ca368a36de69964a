// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How joints are timed along a toolpath (docs/machines/timing.md).
struct TrajectorySettings {
  /// Greatest deviation of the tip at a rounded corner; with 0 the tip stops at corners.
  double blend_tolerance_mm = 0.05;
  /// Greatest deviation of the tool axis where its rotation is rounded; with 0 the nozzle stops where the
  /// rotation changes.
  double blend_tolerance_deg = 0.5;
  /// Greatest deviation of the tip from the straight line between two waypoints.
  double line_tolerance_mm = 0.01;
  double line_tolerance_deg = 0.1;  ///< greatest deviation of the tool axis from its uniform rotation
  /// Time in which a joint goes from rest to its greatest speed, since URDF has no limit of acceleration.
  double joint_ramp_s = 0.2;
  /// Time in which the acceleration of a joint goes from 0 to its greatest; 0 for unlimited jerk.
  double jerk_ramp_s = 0.0;
};

/// Adds the keys trajectory.*.
void describe(SettingsSchema& schema, TrajectorySettings& settings);

}  // namespace lamina
