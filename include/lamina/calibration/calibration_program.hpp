// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

// What a machine runs to be calibrated, on the bed, the nozzle straight down, the sensor's line along x:
// toolpaths that any writer takes. `sensor_offset` is where the middle of the sensor's line lies on the bed,
// seen from the nozzle, as far as it is known [mm].

/// A straight bead whose nozzle runs from start to end [mm, bed].
struct CalibrationBead {
  Point2 start = Point2::Zero();
  Point2 end = Point2::Zero();
};

/// The beads of a cross in a square: the four sides, the arm along x, and the arm along y in two halves that
/// stay clear of it, so that nothing is deposited twice.
std::vector<CalibrationBead> crossBeads(const CalibrationSettings& settings);

/// Where the feeder's amount is stepped along its beads.
struct FeederSteps {
  std::vector<CalibrationBead> beads;  ///< along y, there and back
  std::vector<double> amount;  ///< relative, of each piece in the order of deposition, the same of both
};
FeederSteps feederSteps(const CalibrationSettings& settings);

/// Bobbing over a free place: a triangle of the height whose frequency rises, so that no lag but one fits.
Toolpath bobbingToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// A patch of beads, and passes over its edges along y, there and back.
Toolpath edgeToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// A cross in a square, scanned along y in swaths, and again higher.
Toolpath crossToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

/// Two beads in opposite directions whose amount is stepped, scanned along y.
Toolpath feederToolpath(const CalibrationSettings& settings, const Point2& sensor_offset);

}  // namespace lamina
