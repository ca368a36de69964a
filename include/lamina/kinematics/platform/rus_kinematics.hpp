// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "lamina/kinematics/platform/rus_platform.hpp"

namespace lamina {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Angle of a leg's crank that brings its ball (the centre of its spherical joint) to a position, in (-pi,
/// pi]; empty if the ball is out of reach.
/// @param ball    [mm, base frame]
/// @param branch  which of the two solutions
std::optional<double> crankAngle(const RusLeg& leg, const Point3& ball, CrankBranch branch);

/// Inverse kinematics: the angles of the cranks, each leg in the branch in which it is built. The platform is
/// that of [Guacheta2021, section 1.2.4], which gives no equations.
/// @param pose  base_from_platform [mm]
/// @throws Unreachable naming every leg that does not reach, with its distance and its reach
CrankAngles crankAngles(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// Inverse kinematics as above, but empty instead of an error.
std::optional<CrankAngles> crankAnglesIfReached(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// Forward kinematics by Newton's method on the lengths of the couplers, to 1e-12 of a length.
/// @param near  start of the iteration: platforms with given cranks can be assembled in several ways, and
///   this chooses among them
/// @return base_from_platform; empty if the iteration does not converge
std::optional<Eigen::Isometry3d> poseNear(const RusPlatform& platform, const CrankAngles& cranks,
                                          const Eigen::Isometry3d& near);

/// Forward kinematics of the platform as it is assembled: the pose that is reached from the home pose while
/// the angles of the cranks change linearly from the home angles to the given ones.
/// @throws Unreachable if there is no such pose: the legs cannot be closed, or come through a singularity
Eigen::Isometry3d poseFromHome(const RusPlatform& platform, const CrankAngles& cranks);

/// The velocity equation `pose_rates * (v, w) = crank_rates .* dq/dt` of a platform, with v the velocity of
/// the platform's origin [mm/s] and w its angular velocity [rad/s], both in the base frame. Row i is obtained
/// by projecting the velocities of both ends of leg i's coupler on its direction.
struct VelocityEquation {
  Matrix6 pose_rates = Matrix6::Zero();
  CrankAngles crank_rates = CrankAngles::Zero();  ///< [mm per rad]
};
VelocityEquation velocityEquation(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                  const CrankAngles& cranks);

/// How far a platform is from its singularities: 0 at one.
struct SingularityMargins {
  /// Type 1, a leg is stretched or folded: the least sine of the angle between crank and coupler in the plane
  /// of the crank, times the cosine of the coupler's lean.
  double stretched = 0.0;
  /// Type 2, the couplers do not hold the platform: the ratio of the least to the greatest singular value of
  /// `pose_rates`, with rotations expressed as displacements of a ball at its mean distance.
  double unheld = 0.0;

  double least() const { return std::min(stretched, unheld); }
};
SingularityMargins singularityMargins(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                      const CrankAngles& cranks);

/// Orientation of the platform by the angles of [Guacheta2021, listing A.18]: gamma about its own z, then
/// alpha about x, then beta about the fixed y. The latter two tilt its -z to R_y(beta) R_x(alpha) (0, 0, -1).
struct PlatformAngles {
  double alpha = 0.0;  ///< -pi/2 to pi/2
  double beta = 0.0;   ///< -pi to pi
  double gamma = 0.0;  ///< -pi to pi
};

/// The angles of an orientation.
/// @param rotation  R_y(beta) R_x(alpha) R_z(gamma); if alpha is +-pi/2, gamma is taken as 0
PlatformAngles platformAngles(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotationOf(const PlatformAngles& angles);

}  // namespace lamina
