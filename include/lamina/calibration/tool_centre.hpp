// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A pose of a robot's flange in its base [mm] while the tool's tip is on a fixed point.
struct FlangePose {
  Eigen::Isometry3d base_from_flange = Eigen::Isometry3d::Identity();
  std::size_t line = 0;  ///< of the table that states it, from 1; 0 if none does
};

/// Position of a tool's tip as found from a fixed point that the tip touched in several poses. The tool's
/// orientation is not found.
struct ToolCentreFit {
  Point3 flange_from_tip = Point3::Zero();  ///< [mm]
  Point3 base_from_point = Point3::Zero();  ///< [mm]
  double rms_mm = 0.0;                      ///< of the tip's distances from the point
  std::vector<double> distances_mm;         ///< of each pose
  /// Standard deviations of the tip's place along the flange's axes, from those distances [mm].
  Point3 spread_mm = Point3::Zero();
  /// How well the rotations of the flange determine the tip along the worst direction: 0 for not at all,
  /// about 1 if the flange rotates about all axes.
  double least_determined = 0.0;
  std::vector<std::size_t> outlying;  ///< poses that contradict the others, by their index; all are fitted
};

/// The tip's place by least squares of (R_i - mean R) p = -(t_i - mean t) over all poses.
/// @throws InvalidInput if there are fewer than four poses; or if the flange turns too little, naming the
///   direction along which the tip cannot be found
ToolCentreFit fitToolCentre(const std::vector<FlangePose>& poses);

/// Reads poses from CSV, one a row, with the columns x_mm, y_mm, z_mm and either qw, qx, qy, qz or rx_deg,
/// ry_deg, rz_deg: turns about the fixed axes x, then y, then z, as C, B, A of KUKA, W, P, R of Fanuc and Rx,
/// Ry, Rz of Yaskawa.
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12 or a quaternion is not of unit
///   length within 1 %; also if a column is missing
std::vector<FlangePose> flangePosesFromCsv(std::string_view text, const std::string& source);

}  // namespace lamina
