// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// Method and date of a calibration.
struct CalibrationOrigin {
  /// As `--method` of `lamina calibrate` names it: "bobbing", "edge" or "overlap" for the time offset,
  /// "cross", "bed", "plane", "pyramid" or "pairs" for the sensor's pose, "bead" for the feeder.
  std::string method;
  std::string date;  ///< UTC, as `utcText` gives it
};

/// Time by which the sensor's time stamps are late; see `TimeOffset`.
struct CalibratedTime {
  double offset_s = 0.0;         ///< by which time stamps are late: true time = time stamp - offset
  double spread_s = 0.0;         ///< standard deviation
  double scatter_s = 0.0;        ///< standard deviation from piece to piece of the recording
  double drift_s_per_min = 0.0;  ///< slope of the offset over the recording
  CalibrationOrigin origin;
};

/// Pose of the sensor at the nozzle.
struct CalibratedPose {
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();  ///< [mm]
  /// Six standard deviations: along x, y, z of the nozzle [mm] and of rotations about these [deg]; 0 for
  /// components that were never determined and kept their former value.
  std::vector<double> spread = std::vector<double>(6, 0.0);
  /// Components that were never determined, separated by commas: "z, turn about x"; empty if all were found.
  std::string not_found;
  CalibrationOrigin origin;
};

/// The delay of a feeder behind its commands.
struct CalibratedFeeder {
  double dead_time_s = 0.0;
  double dead_time_spread_s = 0.0;
  double lag_s = 0.0;  ///< time constant of the first-order lag
  double lag_spread_s = 0.0;
  CalibrationOrigin origin;
};

/// Calibration data of a cell's sensor and feeder; each part may be missing.
struct Calibration {
  std::string machine;  ///< name of the machine
  std::string sensor;   ///< name or serial number; empty if none was given
  std::optional<CalibratedTime> time;
  std::optional<CalibratedPose> pose;
  std::optional<CalibratedFeeder> feeder;
};

/// The calibration as YAML. `calibrationFromYaml` reads back exactly the same values, except for the sensor's
/// orientation, which may differ by rounding.
std::string toYaml(const Calibration& calibration);

/// Reads a calibration strictly: a part (time, pose, feeder) has all of its keys or none, method and date
/// included; unknown keys and numbers out of bounds are refused.
/// @param source  names the text in errors
/// @throws InvalidConfig naming the key
Calibration calibrationFromYaml(const std::string& yaml, const std::string& source);

/// Reads a calibration from a file.
/// @throws FileError; InvalidConfig as `calibrationFromYaml`
Calibration readCalibration(const std::string& path);

/// Writes a calibration to a file; on failure an existing file is unchanged.
/// @throws FileError
void writeCalibration(const std::string& path, const Calibration& calibration);

/// Checks that a calibration belongs to a machine.
/// @throws InvalidConfig naming both machines if it does not
void requireCalibrationOf(const Calibration& calibration, const std::string& machine);

}  // namespace lamina
