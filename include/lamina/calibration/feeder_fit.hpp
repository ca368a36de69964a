// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/calibration/calibration_program.hpp"
#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// Length of bead over which a cross-section is averaged [mm].
inline constexpr double kCrossSectionLengthMm = 0.5;

/// Cross-sections measured along a bead: areas above the level of the bed on either side of it.
struct BeadCrossSections {
  std::vector<double> along_mm;  ///< middle of each section, from where the bead begins; ascending
  std::vector<double> area_mm2;
};

/// How the feeder follows the amount that is commanded: after a dead time, then as a first-order lag.
struct FeederFit {
  double dead_time_s = 0.0;
  double dead_time_spread_s = 0.0;  ///< standard deviation
  double lag_s = 0.0;               ///< time constant of the first-order lag
  double lag_spread_s = 0.0;
  double gain = 0.0;      ///< step of the cross-section over the commanded step, both relative; ideally 1
  double shift_mm = 0.0;  ///< by which the scan lies off the program, along the first bead's direction
  double rms = 0.0;       ///< of the sections' residuals, relative to the first bead's section at its start
  std::size_t sections = 0;  ///< number of those measured, on all beads
};

/// Measures the cross-sections of the beads of `feederToolpath` in a scan of them.
/// @param nozzle_from_sensor  [mm]
/// @param time_offset_s  by which the sensor's time stamps are late, as in `TimeOffset`
/// @return an entry for each bead of `steps`, without the places where the scan does not show the bead's
///   whole width
std::vector<BeadCrossSections> beadSections(const SensorRecording& scan,
                                            const Eigen::Isometry3d& nozzle_from_sensor, double time_offset_s,
                                            const FeederSteps& steps);

/// Fits dead time, lag, gain and shift to sections of beads that were deposited at one speed. Beads in
/// opposite directions distinguish the dead time from a shift of the scan.
/// @param speed_mm_s  of the nozzle while the beads were deposited
/// @throws InvalidInput if a bead has fewer than 20 sections, the gain is below 0.1, or the dead time is
///   longer than a step takes
FeederFit fitFeeder(const FeederSteps& steps, const std::vector<BeadCrossSections>& beads, double speed_mm_s);

}  // namespace lamina
