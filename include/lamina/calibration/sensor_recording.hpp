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

/// Where the nozzle was.
struct RecordedPose {
  double time_s = 0.0;
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();  ///< [mm]
};

/// What the sensor saw, stamped by its own clock.
struct RecordedProfile {
  double time_s = 0.0;
  std::vector<Point3> points;  ///< [mm, sensor frame]; z along the viewing direction
};

/// A machine that moves, and what its profile sensor sees meanwhile. Both ascend in time.
struct SensorRecording {
  std::vector<RecordedPose> poses;
  std::vector<RecordedProfile> profiles;
};

/// The pose at a time: straight and turning evenly between two of them. Nothing before the first and after
/// the last.
/// @param poses  ascending in time
std::optional<Eigen::Isometry3d> poseAt(const std::vector<RecordedPose>& poses, double time_s);

/// Reads poses of the nozzle: a CSV with the columns time_s, x_mm, y_mm, z_mm and, for nozzles that do not
/// point straight down, qw, qx, qy, qz (bed_from_nozzle). Sorted by time; of equal times the last counts.
/// Other columns are passed over.
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is no number below 1e12, a quaternion is not of unit length
///   within 1 %, a column is missing, or there are fewer than two poses
std::vector<RecordedPose> posesFromCsv(std::string_view text, const std::string& source);

/// Reads profiles: a CSV with the columns time_s, x_mm, z_mm and, if points leave the plane of light, y_mm;
/// a row for each point in the sensor's frame. Rows of equal times are one profile. Sorted by time.
/// @throws InvalidInput as above, or if there is no point
std::vector<RecordedProfile> profilesFromCsv(std::string_view text, const std::string& source);

/// What these read back.
std::string toCsv(const std::vector<RecordedPose>& poses);
std::string toCsv(const std::vector<RecordedProfile>& profiles);

/// Reads poses.csv and profiles.csv of a folder.
/// @throws FileError; InvalidInput as above
SensorRecording readRecording(const std::string& folder);

/// Writes both.
/// @throws FileError
void writeRecording(const std::string& folder, const SensorRecording& recording);

}  // namespace lamina
