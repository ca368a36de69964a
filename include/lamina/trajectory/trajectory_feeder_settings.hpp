// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a trajectory is handed to a controller.
struct TrajectoryFeederSettings {
  double rate_hz = 250.0;        ///< points of the trajectory per second
  int points = 50;               ///< per chunk
  double ahead_s = 0.5;          ///< of motion that the controller always has
  double reaction_s = 0.05;      ///< from a pause, abort or change to the first point that it changes
  double feed_most = 1.0;        ///< greatest share of the planned speeds, [1, 3]
  double override_ramp_s = 0.5;  ///< in which flow or power would change by what is planned
};

/// Adds the keys feeder.*.
void describe(SettingsSchema& schema, TrajectoryFeederSettings& settings);

}  // namespace lamina
