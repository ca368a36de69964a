// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <string>

#include "arguments/setting_options.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/calibration/flow_trial.hpp"
#include "lamina/calibration/sensor_recording.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/program_settings.hpp"
#include "subcommand.hpp"

namespace lamina::cli {

/// What each part of `lamina calibrate` is given on the command line.
struct CalibrateArguments {
  std::string recording;
  std::string cell;     ///< calibration file; empty for none
  std::string sensor;   ///< its name; empty to leave what the file says
  std::string machine;  ///< name, profile or file; empty for that of the settings
  SettingOptions settings;
};

/// Which machine is calibrated, and how.
struct CalibrateSettings {
  MachineSettings machine;
  CalibrationSettings calibration;
  FlowTrialSettings flow_trial;
  ProgramSettings program;
};

/// Adds the recording, the calibration file, --machine and settings.
void addCalibrateOptions(CLI::App& subcommand, CalibrateArguments& arguments);

/// Adds --machine and settings.
void addCalibratedMachine(CLI::App& subcommand, CalibrateArguments& arguments);

/// The machine's own settings of programs, overridden by the file and then one by one.
/// @throws InvalidConfig, FileError as `applySettings` and `settingsOnMachine`; InvalidConfig if they name
/// another machine
CalibrateSettings calibrateSettingsFrom(const CalibrateArguments& arguments);

/// Reads a folder of tables, or a bag through `lamina-bag-tables` beside this program.
/// @throws FileError, InvalidInput as `readRecording`; InvalidInput with what that program says
SensorRecording recordingFrom(const std::string& path);

/// What the calibration file holds so far, or an empty calibration of the machine.
/// @throws InvalidConfig, FileError as `readCalibration`; InvalidConfig if it is that of another machine
Calibration cellSoFar(const CalibrateArguments& arguments, const MachineSettings& machine);

/// Where the sensor sits as far as is known: as calibrated, else as the machine's description says [mm].
/// @throws InvalidConfig if neither says it
Eigen::Isometry3d knownSensorPose(const Calibration& cell, const MachineSettings& machine);

/// A method, found now.
CalibrationOrigin foundNow(const std::string& method);

/// Writes the calibration file if one was named.
/// @throws FileError
void keepCell(const CalibrateArguments& arguments, const Calibration& cell);

// Parts of `lamina calibrate`.
void addCalibrateTime(CLI::App& calibrate, Chosen& chosen);
void addCalibrateSensor(CLI::App& calibrate, Chosen& chosen);
void addCalibrateFeeder(CLI::App& calibrate, Chosen& chosen);
void addCalibrateFlow(CLI::App& calibrate, Chosen& chosen);
void addCalibratePlan(CLI::App& calibrate, Chosen& chosen);
void addCalibrateTip(CLI::App& calibrate, Chosen& chosen);
void addCalibrateObject(CLI::App& calibrate, Chosen& chosen);
void addCalibratePositioner(CLI::App& calibrate, Chosen& chosen);
void addCalibrateRail(CLI::App& calibrate, Chosen& chosen);

}  // namespace lamina::cli
