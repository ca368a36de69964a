// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "lamina/kinematics/platform/rus_platform.hpp"

namespace lamina {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Angle of one leg's crank that brings its ball to a place, in (-pi, pi]; empty if the ball is out of reach.
/// @param ball    [mm, base frame]
std::optional<double> crankAngle(const RusLeg& leg, const Point3& ball, CrankBranch branch);

/// Inverse kinematics: the cranks' angles, each leg in the branch it is built in. The platform is that of
/// [Guacheta2021, section 1.2.4], which gives no equations.
/// @param pose  base_from_platform [mm]
/// @throws Unreachable naming every leg that does not reach, its distance and what it reaches
CrankAngles crankAngles(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// The same; empty instead of an error.
std::optional<CrankAngles> crankAnglesIfReached(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// Forward kinematics by Newton on the couplers' lengths, to 1e-12 of a length.
/// @param near  where to start: a platform of given cranks can be assembled in several ways, and this chooses
/// @return base_from_platform; empty if Newton does not settle
std::optional<Eigen::Isometry3d> poseNear(const RusPlatform& platform, const CrankAngles& cranks,
                                          const Eigen::Isometry3d& near);

/// Forward kinematics as assembled: the pose that is reached from home, the cranks going straight from theirs
/// at home to the ones asked for.
/// @throws Unreachable if there is no such pose: the legs cannot be closed, or come through a singularity
Eigen::Isometry3d poseFromHome(const RusPlatform& platform, const CrankAngles& cranks);

/// The velocity equation `pose_rates * (v, w) = crank_rates .* dq/dt` of a platform, v the velocity of the
/// platform's origin [mm/s] and w its turn [rad/s], both in the base frame. Row i is leg i's coupler of unit
/// length projected on both of its ends.
struct VelocityEquation {
  Matrix6 pose_rates = Matrix6::Zero();
  CrankAngles crank_rates = CrankAngles::Zero();  ///< [mm per rad]
};
VelocityEquation velocityEquation(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                  const CrankAngles& cranks);

/// How far a platform is from its singularities: 0 at one.
struct SingularityMargins {
  /// Type 1, a leg stretched or folded: the least sine of the angles between crank and coupler within the
  /// plane of the crank, times the cosine of the lean.
  double stretched = 0.0;
  /// Type 2, the couplers do not hold the platform: least over greatest singular value of the velocity
  /// equation, turns taken as motions of a ball at its mean distance.
  double unheld = 0.0;

  double least() const { return std::min(stretched, unheld); }
};
SingularityMargins singularityMargins(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                      const CrankAngles& cranks);

/// Turns of the platform as in [Guacheta2021, listing A.18]: alpha about x, then beta about the fixed y,
/// which tilt its -z to R_y(beta) R_x(alpha) (0, 0, -1); before both, gamma about its own z.
struct PlatformAngles {
  double alpha = 0.0;  ///< -pi/2 to pi/2
  double beta = 0.0;   ///< -pi to pi
  double gamma = 0.0;  ///< -pi to pi
};

/// @param rotation  R_y(beta) R_x(alpha) R_z(gamma); where alpha is +-pi/2 gamma is taken as 0
PlatformAngles platformAngles(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotationOf(const PlatformAngles& angles);

}  // namespace lamina
