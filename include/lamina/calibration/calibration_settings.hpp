// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What is deposited, moved and scanned to calibrate a cell, and how it is evaluated: the same for the
/// program that is run and for its recording.
struct CalibrationSettings {
  double x_mm = 100.0;  ///< middle of it all on the bed
  double y_mm = 100.0;
  double search_s = 0.6;      ///< greatest time offset, either way
  double bob_mm = 2.0;        ///< either way
  double bob_low_hz = 0.5;    ///< at first
  double bob_high_hz = 2.0;   ///< at last
  double bob_s = 10.0;        ///< for so long
  double clearance_mm = 2.0;  ///< of the nozzle over the bed, at least
  int passes = 6;             ///< over an edge, there and back counted apart
  double scan_mm_s = 20.0;
  double lift_mm = 10.0;    ///< scans of a cross are repeated that much higher, so that tilts show; 0: not
  double swath_mm = 28.0;   ///< length of the sensor's line
  double square_mm = 40.0;  ///< side of the square that is deposited around the cross
  double bead_width_mm = 0.8;
  double bead_height_mm = 0.3;
  double bead_mm_s = 20.0;
  double step = 0.2;            ///< share by which the amount is stepped
  double step_mm = 25.0;        ///< of bead from step to step
  double feeder_mm_s = 10.0;    ///< speed of the bead with steps
  double feeder_gap_mm = 10.0;  ///< from bead to bead
  double max_sigma_mm = 0.05;
  double max_sigma_deg = 0.05;
  double noise_mm = 0.005;  ///< least deviation of a point that is believed
};

/// Adds the keys calibrate.*.
void describe(SettingsSchema& schema, CalibrationSettings& settings);

}  // namespace lamina
