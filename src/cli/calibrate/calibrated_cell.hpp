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

/// Arguments of each part of `lamina calibrate`.
struct CalibrateArguments {
  std::string recording;
  std::string cell;     ///< calibration file; empty for none
  std::string sensor;   ///< name of the sensor; empty to keep that of the file
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
///   another machine
CalibrateSettings calibrateSettingsFrom(const CalibrateArguments& arguments);

/// Reads a folder of tables, or a bag through `lamina-bag-tables` beside this program.
/// @throws FileError, InvalidInput as `readRecording`; InvalidInput with what that program says
SensorRecording recordingFrom(const std::string& path);

/// The present calibration of the file, or an empty calibration of the machine.
/// @throws InvalidConfig, FileError as `readCalibration`; InvalidConfig if it belongs to another machine
Calibration cellSoFar(const CalibrateArguments& arguments, const MachineSettings& machine);

/// The known pose of the sensor: as calibrated, otherwise by the machine's description [mm].
/// @throws InvalidConfig if neither states it
Eigen::Isometry3d knownSensorPose(const Calibration& cell, const MachineSettings& machine);

/// The origin of a value found now by a method.
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
