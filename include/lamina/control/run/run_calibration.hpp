// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/calibration/calibration_file.hpp"
#include "lamina/control/run/loop_run_settings.hpp"

namespace lamina {

/// The settings, completed by a calibration. A value that the settings state takes precedence: a trusted time
/// offset or place, a dead time, lag, spread, error or scatter above 0.
///
/// The calibration of time gives the offset and its spread. The calibration of the pose gives the place of
/// the sensor, which replaces that of tf, and the scatter along the growth direction. It also gives the error
/// of that place along the path: from the errors of the shifts, and those of the turns times the distance of
/// sensor and nozzle tip. Values that the calibration kept count as exact. The calibration of the feeder
/// gives dead time and lag, and the uncertainty of both together.
///
/// `calibration.sources` states for clock, place and feeder the value that holds, its origin, and the value
/// that was passed over.
/// @throws InvalidConfig if a value lies outside the bounds of its setting, naming it
LoopRunSettings withCalibration(const LoopRunSettings& settings, const Calibration& found);

/// The same with the file that `sensor.calibration` names; with an empty calibration if it names none.
/// @throws FileError, InvalidConfig as `readCalibration`
LoopRunSettings withCalibrationFile(const LoopRunSettings& settings);

/// The settings by which amounts are led for a feeder, and their origin in words.
struct CalibratedFeeding {
  LoopSettings loop;
  std::string source;
};

/// The settings for a machine's executor, with dead time and lag of the calibration file unless they are
/// stated.
/// @param file  as `sensor.calibration` names it; empty for none
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig with both names if it is that of
/// another
///   machine, or a value lies outside the bounds of its setting
CalibratedFeeding withFeederOf(const std::string& file, const LoopSettings& loop, const std::string& machine);

/// Reads the calibration of a machine from a file.
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig naming the file and both machines
Calibration readCalibrationOf(const std::string& file, const std::string& machine);

/// Checks the stability of the loop over a print (`checkStability`). The calibration of another machine is
/// refused, naming both.
/// @param machine  for which the toolpath is
StabilityReport checkStart(const Toolpath& toolpath, const std::string& machine,
                           const LoopRunSettings& settings);

}  // namespace lamina
