// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/calibration/calibration_file.hpp"
#include "lamina/control/run/loop_run_settings.hpp"

namespace lamina {

/// The settings, completed by the results of a calibration. What the settings state takes precedence: a time
/// offset or a pose that is trusted; dead time and lag of the feeder, if either is not 0; a spread, error or
/// scatter that is not 0.
///
/// The calibration of time gives the time offset and its spread. The calibration of the pose gives the pose
/// of the sensor, which replaces that of tf; the standard deviation along the growth direction
/// (`sight.pose_sigma_mm`); and the error along the path (`sensor.place_error_mm`). The latter combines the
/// standard deviations of the translations across the growth direction with those of the tilts, multiplied by
/// the height of the sensor above the nozzle tip. Values that the calibration did not determine count as
/// exact. The calibration of the feeder gives dead time and lag, and the uncertainty of both together.
///
/// `calibration.sources` states for clock, pose and feeder the value used, its origin, and the value that was
/// not used because the settings state another one.
/// @throws InvalidConfig naming the setting if a value is out of its bounds
LoopRunSettings withCalibration(const LoopRunSettings& settings, const Calibration& found);

/// The settings, completed by the file that `sensor.calibration` names; as with an empty calibration if it
/// names none.
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig as `withCalibration`
LoopRunSettings withCalibrationFile(const LoopRunSettings& settings);

/// The settings by which amounts are led for a feeder, and the origin of dead time and lag in words.
struct CalibratedFeeding {
  LoopSettings loop;
  std::string source;
};

/// The settings of the program that runs a machine, with dead time and lag of the calibration file unless the
/// settings state them.
/// @param file  as `sensor.calibration` names it; empty for none
/// @throws FileError, InvalidConfig as `readCalibrationOf`; InvalidConfig if a value is out of the bounds of
///   its setting
CalibratedFeeding withFeederOf(const std::string& file, const LoopSettings& loop, const std::string& machine);

/// Reads the calibration of a machine from a file.
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig naming the file and both machines if
///   it is that of another machine
Calibration readCalibrationOf(const std::string& file, const std::string& machine);

/// Checks the stability of the loop over a print (`checkStability`). With the calibration of another machine
/// the loop may not start, and the reason names both machines.
/// @param machine  for which the toolpath was planned
StabilityReport checkStart(const Toolpath& toolpath, const std::string& machine,
                           const LoopRunSettings& settings);

}  // namespace lamina
