// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace lamina {

/// A rotation as three angles [deg]: by x about the fixed x axis, then by y about the fixed y axis, then by z
/// about the fixed z axis; as matrices, Rz(z) Ry(y) Rx(x). KUKA calls them C, B, A, Fanuc W, P, R, Yaskawa
/// Rx, Ry, Rz.
struct RobotAngles {
  double x_deg = 0.0;  ///< (-180, 180]
  double y_deg = 0.0;  ///< -90 to 90
  double z_deg = 0.0;  ///< (-180, 180]
};

/// The angles of a rotation.
/// @param near_x_deg  value that x gets if y is within 1e-6 rad of 90 deg or -90 deg, where x and z rotate
///   about the same axis
RobotAngles robotAngles(const Eigen::Quaterniond& turn, double near_x_deg = 0.0);

/// The rotation by the angles, as a quaternion of unit length.
Eigen::Quaterniond rotationOfAngles(const RobotAngles& angles);

/// The rotation vector of a rotation: its axis, with the angle [rad] from 0 to pi as length. For a rotation
/// by pi, the first coordinate of the axis other than 0 is positive.
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& turn);

/// The rotation of a rotation vector [rad], as a quaternion of unit length.
Eigen::Quaterniond rotationOfVector(const Eigen::Vector3d& rotation_vector);

}  // namespace lamina
