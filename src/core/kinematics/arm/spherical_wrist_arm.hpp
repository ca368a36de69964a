// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/model/serial_chain.hpp"

namespace lamina {

/// Geometry of an arm with six rotary axes and a spherical wrist: axis 2 is at a right angle to axis 1, axis
/// 3 is parallel to axis 2, and axes 4, 5 and 6 pass through one point, the wrist, each at a right angle to
/// the one before. Nearly all industrial arms are of this kind.
///
/// The plane of the arm contains the direction of axis 1 (z) and the direction x, at a right angle to axis 2.
/// x points to the front: to where axis 2 is, or, if axes 1 and 2 intersect, to where the wrist is with all
/// joints at zero. Angles in the plane are counted from z to x.
struct SphericalWristArm {
  Eigen::Isometry3d base_from_bed = Eigen::Isometry3d::Identity();      ///< origin: axis 1, at axis 2 [mm]
  Eigen::Isometry3d nozzle_from_wrist = Eigen::Isometry3d::Identity();  ///< z of the wrist is axis 6 [mm]
  double shoulder_mm = 0.0;                                             ///< x of axis 2
  double side_mm = 0.0;   ///< distance of the wrist from the plane through axis 1, along y
  double upper_mm = 0.0;  ///< distance from axis 2 to axis 3
  double fore_mm = 0.0;   ///< distance from axis 3 to the wrist
  /// Rotation of axes 4 (z) and 5 (y) against the forearm, whose z points from axis 3 to the wrist, and whose
  /// y is that of the base.
  Eigen::Matrix3d fore_from_wrist4 = Eigen::Matrix3d::Identity();
  /// Angles of the joints at value 0; the angle of a joint is zero + sense * value. They are counted: for
  /// axis 1 from the base, for the upper arm from z, for the forearm from the upper arm, for axes 4, 5 and 6
  /// from the position in which axes 4 and 6 are in line.
  ArmValues zero = ArmValues::Zero();
  ArmValues sense = ArmValues::Ones();
  /// Greatest deviation of the URDF's axes from this geometry, of tilts [rad] and of distances [mm].
  double deviation = 0.0;
};

/// The geometry of an arm with these axes at all joints zero. Nothing if an axis deviates by more than 1e-3
/// rad or 0.1 mm.
std::optional<SphericalWristArm> sphericalWristArm(const std::array<Screw, 6>& axes,
                                                   const Eigen::Isometry3d& bed_from_nozzle_at_zero);

/// All joint values that bring the nozzle to a pose; none if the pose is out of reach. At a singularity,
/// branches that meet there have equal values. Does not allocate memory.
/// @param near  values from which joint 1 is kept if axis 1 passes through the wrist, and joint 4 if axes 4
///   and 6 are in line
ArmSolutions solutions(const SphericalWristArm& arm, const Eigen::Isometry3d& bed_from_nozzle,
                       const ArmValues& near);

ArmSines singularSines(const SphericalWristArm& arm, const ArmValues& values);

}  // namespace lamina
