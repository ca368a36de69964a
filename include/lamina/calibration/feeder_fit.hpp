// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/calibration/calibration_program.hpp"
#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// Length of bead over which a section is a mean [mm].
inline constexpr double kSectionMm = 0.5;

/// Cross-section of a bead by place, over the bed beside it.
struct BeadSections {
  std::vector<double> along_mm;  ///< from where the bead begins, ascending
  std::vector<double> area_mm2;
};

/// How late a feeder follows: after a dead time, and then as a first-order lag.
struct FeederFit {
  double dead_time_s = 0.0;
  double dead_time_spread_s = 0.0;  ///< standard deviation
  double lag_s = 0.0;
  double lag_spread_s = 0.0;
  double gain = 0.0;      ///< of the bead's section over that of the commanded steps
  double shift_mm = 0.0;  ///< of the scan against the program, along the beads
  double rms = 0.0;       ///< of the sections, relative
  std::size_t sections = 0;
};

/// Sections of the feeder's beads out of a scan.
/// @param nozzle_from_sensor  [mm]
/// @return one for each bead of `steps`; without places where it was not seen
std::vector<BeadSections> beadSections(const SensorRecording& scan,
                                       const Eigen::Isometry3d& nozzle_from_sensor, double time_offset_s,
                                       const FeederSteps& steps);

/// Fits dead time, lag, gain and shift to sections of beads that were deposited at one speed. Beads in
/// opposite directions distinguish the dead time from a shift of the scan.
/// @param speed_mm_s  at which they were deposited
/// @throws InvalidInput if one of two beads has fewer than 20 sections, sections do not follow the steps, or
///   the dead time is longer than a step takes
FeederFit fitFeeder(const FeederSteps& steps, const std::vector<BeadSections>& beads, double speed_mm_s);

}  // namespace lamina
