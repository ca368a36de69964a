// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/calibration/calibration_file.hpp"
#include "lamina/control/run/run_settings.hpp"

namespace lamina {

/// The settings with what a calibration says where they say nothing themselves. What is stated in the
/// settings wins: a time offset or a place that is trusted there, a dead time or lag, a spread, an error or a
/// scatter above 0.
///
/// Of the time comes the offset with its spread. Of the pose comes where the sensor sits, which then stands
/// in place of tf; its error along the path, of the shifts and of the turns over the distance of sensor and
/// nozzle tip; and the scatter along the growth. What the calibration kept counts as exact. Of the feeder
/// come dead time and lag, and the uncertainty of both together.
///
/// `calibration.sources` then says of clock, place and feeder what counts, from where, and what was passed
/// over.
/// @throws InvalidConfig if a value lies outside the bounds of its setting, naming it
LoopRunSettings withCalibration(const LoopRunSettings& settings, const Calibration& found);

/// The same with the file that `sensor.calibration` names; with an empty one if it names none.
/// @throws FileError, InvalidConfig as `readCalibration`
LoopRunSettings withCalibrationFile(const LoopRunSettings& settings);

/// What leads a feeder, and whence in words.
struct CalibratedFeeding {
  LoopSettings loop;
  std::string source;
};

/// Dead time and lag of the file that `sensor.calibration` names, for a machine's executor, unless they are
/// stated; as stated where it names none.
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig with both names if it is that of
/// another
///   machine, or a value lies outside the bounds of its setting
CalibratedFeeding withFeederOf(const std::string& file, const LoopSettings& loop, const std::string& machine);

/// The calibration of a file that is that of a machine.
/// @throws FileError, InvalidConfig as `readCalibration`; InvalidConfig naming the file and both machines
Calibration readCalibrationOf(const std::string& file, const std::string& machine);

/// `checkStability` of a loop over a print, which refuses the calibration of another machine, by both names.
/// @param machine  that the toolpath is for
StabilityReport checkStart(const Toolpath& toolpath, const std::string& machine,
                           const LoopRunSettings& settings);

}  // namespace lamina
