// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/calibration_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CalibrationSettings& settings) {
  const Bounds place{-1e5, 1e5};
  const Bounds length = Bounds::above(0.0, 1000.0);
  const Bounds frequency = Bounds::above(0.0, 50.0);
  const Bounds speed = Bounds::above(0.0, 1000.0);
  schema.number("calibrate.x_mm", settings.x_mm, place,
                "Middle of what is deposited and scanned, on the bed.");
  schema.number("calibrate.y_mm", settings.y_mm, place,
                "Middle of what is deposited and scanned, on the bed.");
  schema.number("calibrate.search_s", settings.search_s, Bounds::above(0.0, 5.0),
                "Greatest time offset looked for, either way.");
  schema.number("calibrate.bob_mm", settings.bob_mm, length, "Height of bobbing, either way.");
  schema.number("calibrate.bob_low_hz", settings.bob_low_hz, frequency, "Frequency of bobbing at first.");
  schema.number("calibrate.bob_high_hz", settings.bob_high_hz, frequency, "Frequency of bobbing at last.");
  schema.number("calibrate.bob_s", settings.bob_s, {4.0, 600.0}, "Duration of bobbing.");
  schema.number("calibrate.clearance_mm", settings.clearance_mm, length,
                "The nozzle stays that far above the bed while it scans or bobs.");
  schema.integer("calibrate.passes", settings.passes, {2, 1000}, "Passes over an edge, there and back.");
  schema.number("calibrate.scan_mm_s", settings.scan_mm_s, speed, "Speed of scans.");
  schema.number("calibrate.lift_mm", settings.lift_mm, {0.0, 1000.0},
                "The cross is scanned again that much higher, so that tilts of the sensor show; 0: not.");
  schema.number("calibrate.swath_mm", settings.swath_mm, length, "Length of the sensor's line on the bed.");
  schema.number("calibrate.square_mm", settings.square_mm, {10.0, 1000.0},
                "Side of the square that is deposited around the cross.");
  schema.number("calibrate.bead_width_mm", settings.bead_width_mm, Bounds::above(0.0, 100.0),
                "Width of beads.");
  schema.number("calibrate.bead_height_mm", settings.bead_height_mm, Bounds::above(0.0, 100.0),
                "Height of beads.");
  schema.number("calibrate.bead_mm_s", settings.bead_mm_s, speed, "Speed at which beads are deposited.");
  schema.number("calibrate.step", settings.step, Bounds::above(0.0, 0.9),
                "Share by which the amount of the feeder's bead is stepped up and down.");
  schema.number("calibrate.step_mm", settings.step_mm, length, "Length of the feeder's bead between steps.");
  schema.number("calibrate.feeder_mm_s", settings.feeder_mm_s, speed, "Speed of the feeder's bead.");
  schema.number("calibrate.feeder_gap_mm", settings.feeder_gap_mm, length,
                "Distance of the feeder's two beads.");
  schema.number("calibrate.max_sigma_mm", settings.max_sigma_mm, Bounds::above(0.0, 10.0),
                "A shift of the sensor with a greater standard deviation counts as not found.");
  schema.number("calibrate.max_sigma_deg", settings.max_sigma_deg, Bounds::above(0.0, 10.0),
                "A turn of the sensor with a greater standard deviation counts as not found.");
  schema.number("calibrate.noise_mm", settings.noise_mm, Bounds::above(0.0, 10.0),
                "Standard deviation of a point, at least.");
}

}  // namespace lamina
