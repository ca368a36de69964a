// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

// Toolpaths that a machine runs for calibration, in coordinates of the bed, which any program writer accepts.
// The nozzle points straight down, and the sensor's line is parallel to x. `sensor_offset` is the position of
// the middle of the sensor's line on the bed relative to the nozzle, as far as it is known [mm].

/// A straight bead: the nozzle runs from `start` to `end` [mm, bed].
struct CalibrationBead {
  Point2 start = Point2::Zero();
  Point2 end = Point2::Zero();
};

/// The beads of a cross in a square: the four sides, the arm along x, and the arm along y in two halves that
/// keep a distance from the arm along x, so that nothing is deposited twice.
std::vector<CalibrationBead> crossBeads(const CalibrationSettings& settings);

/// The feeder's beads, along which the amount is stepped.
struct FeederSteps {
  std::vector<CalibrationBead> beads;  ///< one in +y, one in -y
  /// Amount of each piece over the nominal one, in the order of deposition; pieces are equally long, and the
  /// same on both beads.
  std::vector<double> amount;
};
/// The beads and steps by the settings.
FeederSteps feederSteps(const CalibrationSettings& settings);

/// Bobbing (moving up and down) over a free part of the bed. The height is a triangle wave whose frequency
/// rises, so that only the right lag fits.
Toolpath bobbingToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// A patch of beads, and passes over its edges in +y and -y by turns.
Toolpath edgeToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// A cross in a square, scanned along y in swaths; and a second scan, `lift_mm` higher, unless that is 0.
Toolpath crossToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// Two beads in opposite directions whose amount is stepped (`feederSteps`), scanned along y.
Toolpath feederToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

}  // namespace lamina
