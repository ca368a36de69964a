// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The pose of the nozzle at a time.
struct RecordedPose {
  double time_s = 0.0;
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();  ///< [mm]
};

/// A profile of the sensor, with the time stamp of the sensor's clock.
struct RecordedProfile {
  double time_s = 0.0;
  std::vector<Point3> points;  ///< [mm, sensor frame]; z along the viewing direction
};

/// The motion of a machine, and the profiles of its sensor meanwhile. Both ascend in time.
struct SensorRecording {
  std::vector<RecordedPose> poses;
  std::vector<RecordedProfile> profiles;
};

/// The pose at a time, interpolated between the poses before and after: linearly in position, at a constant
/// rate in orientation. Nothing before the first and after the last.
/// @param poses  ascending in time
std::optional<Eigen::Isometry3d> poseAt(const std::vector<RecordedPose>& poses, double time_s);

/// Reads poses of the nozzle from CSV with the columns time_s, x_mm, y_mm, z_mm and, for nozzles that do not
/// point straight down, qw, qx, qy, qz (bed_from_nozzle). The result is sorted by time; of rows with equal
/// times the last is used. Other columns are ignored.
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12 or a quaternion is not of unit
///   length within 1 %; also if a column is missing, or there are fewer than two poses
std::vector<RecordedPose> posesFromCsv(std::string_view text, const std::string& source);

/// Reads profiles from CSV with the columns time_s, x_mm, z_mm and, if points leave the plane of the sensor's
/// light, y_mm; a row for each point in the sensor's frame. Successive rows of equal times are one profile.
/// The result is sorted by time. Points that are exactly zero are left out: sensors send them in place of
/// missing points.
/// @param source  names the table in errors
/// @throws InvalidInput as `posesFromCsv`; also if there is no point
std::vector<RecordedProfile> profilesFromCsv(std::string_view text, const std::string& source);

/// Poses or profiles as CSV that `posesFromCsv` and `profilesFromCsv` read back.
std::string toCsv(const std::vector<RecordedPose>& poses);
std::string toCsv(const std::vector<RecordedProfile>& profiles);

/// Reads poses.csv and profiles.csv from a folder.
/// @throws FileError if one cannot be read; InvalidInput as `posesFromCsv` and `profilesFromCsv`
SensorRecording readRecording(const std::string& folder);

/// Writes poses.csv and profiles.csv into a folder.
/// @throws FileError if one cannot be written
void writeRecording(const std::string& folder, const SensorRecording& recording);

}  // namespace lamina
