// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of what is deposited, moved and scanned to calibrate a cell, and of the evaluation. Program and
/// evaluation need the same settings.
struct CalibrationSettings {
  double x_mm = 100.0;  ///< middle, on the bed, of all that is deposited and scanned
  double y_mm = 100.0;
  double search_s = 0.6;      ///< greatest time offset looked for, either way
  double bob_mm = 2.0;        ///< amplitude of bobbing
  double bob_low_hz = 0.5;    ///< frequency of bobbing at its beginning
  double bob_high_hz = 2.0;   ///< frequency of bobbing at its end
  double bob_s = 10.0;        ///< duration of bobbing
  double clearance_mm = 2.0;  ///< least height of the nozzle above bed or beads while it scans or bobs
  int passes = 6;             ///< number of passes over an edge, both directions counted
  double scan_mm_s = 20.0;    ///< speed of scans
  /// A cross is scanned a second time that much higher, so that tilts of the sensor show; 0: it is not.
  double lift_mm = 10.0;
  double swath_mm = 28.0;   ///< length of the sensor's line on the bed
  double square_mm = 40.0;  ///< side of the square that is deposited around the cross
  double bead_width_mm = 0.8;
  double bead_height_mm = 0.3;
  double bead_mm_s = 20.0;      ///< speed at which beads are deposited
  double step = 0.2;            ///< share by which the amount of the feeder's beads is stepped up and down
  double step_mm = 25.0;        ///< length of the feeder's beads between steps
  double feeder_mm_s = 10.0;    ///< speed at which the feeder's beads are deposited
  double feeder_gap_mm = 10.0;  ///< distance of the feeder's beads
  /// Shifts of the sensor with a greater standard deviation count as not found.
  double max_sigma_mm = 0.05;
  /// Rotations of the sensor with a greater standard deviation count as not found.
  double max_sigma_deg = 0.05;
  double noise_mm = 0.005;  ///< least value assumed for the standard deviation of a point
};

/// Adds the keys calibrate.*.
void describe(SettingsSchema& schema, CalibrationSettings& settings);

}  // namespace lamina
