// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The nozzle's pose, and that of a body at rest on the bed as the sensor saw it from there [mm].
struct BodySight {
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d sensor_from_body = Eigen::Isometry3d::Identity();
};

/// Where a sensor sits by a body seen from several poses.
struct HandEyeFit {
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();
  double rms_mm = 0.0;   ///< by which the body's places on the bed disagree
  double rms_deg = 0.0;  ///< by which its turns do
  /// Singular values of the closed form, of turns and of the place, greatest first: turns of the head over
  /// all pairs about three axes [rad], and how well they determine the place [1].
  std::vector<double> turn_values;
  std::vector<double> place_values;
};

/// The closed form of A X = X B for pairs of poses [Park1994]. The head must turn about two axes that are not
/// parallel.
/// @param sights  three at least
/// @throws InvalidInput if there are fewer, or the head turns about one axis only, or by less than 5 deg;
///   names what cannot be determined
HandEyeFit fitHandEye(const std::vector<BodySight>& sights);

/// Reads sights: a CSV with the columns x_mm, y_mm, z_mm, qw, qx, qy, qz (bed_from_nozzle) and body_x_mm,
/// body_y_mm, body_z_mm, body_qw, body_qx, body_qy, body_qz (sensor_from_body), one sight a row.
/// @throws InvalidInput naming the line if a cell is no number below 1e12 or a quaternion not of unit length
std::vector<BodySight> sightsFromCsv(std::string_view text, const std::string& source);

}  // namespace lamina
