// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/model/serial_chain.hpp"

namespace lamina {

/// An arm of six rotary axes: 2 at a right angle to 1, 3 parallel to 2, and 4, 5 and 6 through one point, the
/// wrist, each at a right angle to the one before. Nearly all industrial arms are of this kind.
///
/// Its plane holds the directions of axis 1 (z) and x, at a right angle to axis 2; x is to the front: where
/// axis 2 is over the base, or the wrist with all joints at zero if axes 1 and 2 cross. Angles in the plane
/// count from z to x.
struct SphericalWristArm {
  Eigen::Isometry3d base_from_bed = Eigen::Isometry3d::Identity();      ///< origin: axis 1, at axis 2 [mm]
  Eigen::Isometry3d nozzle_from_wrist = Eigen::Isometry3d::Identity();  ///< z of the wrist is axis 6 [mm]
  double shoulder_mm = 0.0;                                             ///< x of axis 2
  double side_mm = 0.0;   ///< of the wrist to the plane through axis 1, along y
  double upper_mm = 0.0;  ///< axis 2 to axis 3
  double fore_mm = 0.0;   ///< axis 3 to the wrist
  /// Axes 4 (z) and 5 (y), seen from the forearm: z from axis 3 to the wrist, y of the base.
  Eigen::Matrix3d fore_from_wrist4 = Eigen::Matrix3d::Identity();
  /// Of axis 1, of the upper arm from z, of the forearm from the upper arm, of axes 4, 5 and 6 from where 4
  /// and 6 are in line and as at zero: the angle is zero + sense * value of the joint.
  ArmValues zero = ArmValues::Zero();
  ArmValues sense = ArmValues::Ones();
  /// How far the joints of the URDF are from this: tilt of axes [rad] and distance [mm], the greatest of all.
  double deviation = 0.0;
};

/// The arm with these axes, all joints at zero. None if an axis stands off by more than 1e-3 rad or 0.1 mm.
std::optional<SphericalWristArm> sphericalWristArm(const std::array<Screw, 6>& axes,
                                                   const Eigen::Isometry3d& bed_from_nozzle_at_zero);

/// All joint values that bring the nozzle to a pose; none if it is out of reach. At a singularity branches
/// that meet there have the same values. Takes no memory from the heap.
/// @param near  where axis 1 goes through the wrist its value is kept, where axes 4 and 6 are in line that of
/// axis 4
ArmSolutions solutions(const SphericalWristArm& arm, const Eigen::Isometry3d& bed_from_nozzle,
                       const ArmValues& near);

ArmSines singularSines(const SphericalWristArm& arm, const ArmValues& values);

}  // namespace lamina
