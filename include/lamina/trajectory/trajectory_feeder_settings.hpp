// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a trajectory is handed to a controller.
struct TrajectoryFeederSettings {
  double rate_hz = 250.0;        ///< points of the trajectory per second
  int points = 50;               ///< number of points of a chunk
  double ahead_s = 0.5;          ///< least duration of the motion that the controller has queued
  double reaction_s = 0.05;      ///< time from a pause, abort or change to the first point that it changes
  double feed_most = 1.0;        ///< greatest share of the planned speeds that may be set, 1 to 3
  double override_ramp_s = 0.5;  ///< time in which the share of flow or power changes by 1
};

/// Adds the keys feeder.*.
void describe(SettingsSchema& schema, TrajectoryFeederSettings& settings);

}  // namespace lamina
