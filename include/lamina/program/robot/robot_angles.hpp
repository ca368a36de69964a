// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace lamina {

/// A turn as three angles [deg]: by x about the fixed x axis, then by y about the fixed y axis, then by z
/// about the fixed z axis, which is Rz(z) Ry(y) Rx(x). KUKA calls them C, B, A, Fanuc W, P, R, Yaskawa Rx,
/// Ry, Rz.
struct RobotAngles {
  double x_deg = 0.0;  ///< (-180, 180]
  double y_deg = 0.0;  ///< -90 to 90
  double z_deg = 0.0;  ///< (-180, 180]
};

/// The angles of a turn.
/// @param near_x_deg  x where y is 90 deg or -90 deg, up to 1e-6 rad: there x and z turn about one axis
RobotAngles robotAngles(const Eigen::Quaterniond& turn, double near_x_deg = 0.0);

/// The turn of the angles, of unit length.
Eigen::Quaterniond turnOfAngles(const RobotAngles& angles);

/// A turn as the axis it goes about, of the length of its angle [rad], from 0 to pi. Of a half turn that of
/// the two axes whose first coordinate that is not 0 is positive.
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& turn);

/// The turn of a rotation vector [rad], of unit length.
Eigen::Quaterniond turnOfVector(const Eigen::Vector3d& rotation_vector);

}  // namespace lamina
