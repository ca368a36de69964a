// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "kinematics/arm/arm_chain.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The axes of an arm of seven joints with all of them at zero [mm, bed frame], each at a right angle to the
/// next within 1e-3 rad.
///
/// The shoulder is the point of axis 1 nearest to axis 2; no joint moves the shoulder. The wrist is the point
/// of axis 6 nearest to axis 5; joints 1 to 5 move the wrist. The points of axes 1 to 3 are those nearest to
/// the shoulder, the points of axes 5 to 7 those nearest to the wrist.
struct SevenAxes {
  std::array<Screw, 7> axes;
  Eigen::Isometry3d bed_from_nozzle_at_zero = Eigen::Isometry3d::Identity();
  Point3 shoulder = Point3::Zero();
  Point3 wrist = Point3::Zero();
  /// -1 if axis 4 points opposite to axis 2 with all joints at zero, otherwise 1.
  double elbow_sense = 1.0;
};

/// @throws InvalidConfig naming the joints if neighbouring axes are not at right angles
SevenAxes sevenAxes(const SerialChain& arm);

/// Greatest distance of axes 1 to 3 from the shoulder and of axes 5 to 7 from the wrist [mm].
double offsetOf(const SevenAxes& arm);
/// Greatest angle by which neighbouring axes miss a right angle [rad].
double tiltOf(const SevenAxes& arm);

/// The arm with its axes shifted, not rotated. At `part` 0 the axes of shoulder and wrist pass through these
/// two points; at 1 the arm is unchanged.
SevenAxes movedAxes(const SevenAxes& arm, double part);

/// Positions of the axes and the nozzle at joint values.
struct SevenPosture {
  std::array<Screw, 7> axes;
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  Point3 wrist = Point3::Zero();
};
SevenPosture postureOf(const SevenAxes& arm, const SevenValues& values);

/// The arm angle [rad], in (-pi, pi]: the rotation of axis 4 about the line from the shoulder to the wrist.
/// At 0, axis 4 is at a right angle to axis 1 with the wrist in front of axis 1: the arm moves in a plane
/// like a six-axis arm, with joint 3 at zero. The angle is undefined, and 0, while the wrist is on axis 1.
double armAngle(const SevenAxes& arm, const SevenPosture& posture);

/// Derivatives of the arm angle by the joint values.
Eigen::Matrix<double, 1, 7> armAngleRates(const SevenAxes& arm, const SevenPosture& posture);

/// Signed sines that vanish at the singularities of an arm whose arm angle is given.
struct SevenSines {
  double shoulder = 1.0;  ///< from axis 1 to axis 3, about axis 2
  double elbow = 1.0;     ///< about axis 4, from what is before to what is after it
  double wrist = 1.0;     ///< from axis 5 to axis 7, about axis 6
  double plane = 1.0;     ///< from axis 1 to the line from the shoulder to the wrist; never negative
};
SevenSines sinesOf(const SevenAxes& arm, const SevenPosture& posture);

}  // namespace lamina
