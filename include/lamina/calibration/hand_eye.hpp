// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// A pose of the nozzle, and the pose of a body at rest on the bed as the sensor measured it from there [mm].
struct BodySight {
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d sensor_from_body = Eigen::Isometry3d::Identity();
};

/// The pose of a sensor as found from a body that was measured from several poses.
struct HandEyeFit {
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();
  double rms_mm = 0.0;   ///< scatter of the body's position on the bed; ideally 0
  double rms_deg = 0.0;  ///< scatter of its orientation
  /// Singular values of the closed form, greatest first. `rotation_singular_values`: rotations of the head
  /// about three axes, over all pairs of poses [rad]. `place_values`: how well these determine the sensor's
  /// position [1].
  std::vector<double> rotation_singular_values;
  std::vector<double> place_values;
};

/// The sensor's pose by the closed form of A X = X B for pairs of poses [Park1994]. The head must rotate
/// about two axes that are not parallel.
/// @param sights  at least three
/// @throws InvalidInput stating what cannot be determined, if the head rotates about one axis only or by less
///   than 5 deg; also if there are fewer than three sights
HandEyeFit fitHandEye(const std::vector<BodySight>& sights);

/// Reads sights from CSV, one a row, with the columns x_mm, y_mm, z_mm, qw, qx, qy, qz (bed_from_nozzle) and
/// body_x_mm, body_y_mm, body_z_mm, body_qw, body_qx, body_qy, body_qz (sensor_from_body).
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12 or a quaternion is not of unit
///   length within 1 %; also if a column is missing
std::vector<BodySight> sightsFromCsv(std::string_view text, const std::string& source);

}  // namespace lamina
