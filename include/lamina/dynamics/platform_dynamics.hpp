// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "lamina/dynamics/platform_inertia.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {

/// Velocity of a platform's origin [m/s] and its angular velocity [rad/s], in the base frame.
using Twist = Eigen::Matrix<double, 6, 1>;

/// A platform with lengths in metres, as needed to compute forces.
struct MetricPlatform {
  RusPlatform platform;  ///< all lengths in m, also those whose names end in _mm
};
/// The platform with its lengths converted from millimetres to metres.
MetricPlatform inMetres(RusPlatform platform);

/// The state of a platform in motion.
struct PlatformState {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [m]
  CrankAngles cranks = CrankAngles::Zero();                ///< angles that belong to the pose [rad]
  Twist twist = Twist::Zero();
};

/// The relation between the rates q' of the cranks and the motion of platform and legs: twist =
/// `twist_from_rates` * q', and the derivative of the twist is `twist_from_rates` * q'' + `bias`.
struct PlatformRates {
  struct Leg {
    Point3 arm = Point3::Zero();      ///< from the platform's origin to the ball joint [m, base frame]
    Point3 crank = Point3::Zero();    ///< from motor to elbow [m, base frame]
    Point3 tangent = Point3::Zero();  ///< derivative of the elbow's position by the crank's angle [m/rad]
  };
  std::array<Leg, kLegs> legs;
  CrankAngles cranks = CrankAngles::Zero();  ///< rates q' of the cranks [rad/s]
  Matrix6 twist_from_rates = Matrix6::Zero();
  Twist bias = Twist::Zero();
};

/// The relation in a state. At a singularity it is not finite.
PlatformRates ratesOf(const MetricPlatform& platform, const PlatformState& state);

/// Terms of the equation of motion: torque = mass * q'' + coriolis + gravity + friction [N m], q being the
/// angles of the cranks.
struct PlatformTerms {
  Matrix6 mass = Matrix6::Zero();  ///< [kg m²]
  CrankAngles coriolis = CrankAngles::Zero();
  CrankAngles gravity = CrankAngles::Zero();
  CrankAngles friction = CrankAngles::Zero();

  /// Torques for which no crank accelerates [N m].
  CrankAngles withoutAcceleration() const { return coriolis + gravity + friction; }
};
/// The terms in a state.
PlatformTerms termsOf(const PlatformState& state, const PlatformRates& rates, const PlatformInertia& inertia);

/// Inverse dynamics: the torques of the cranks [N m] for given accelerations [rad/s²].
CrankAngles torquesFor(const PlatformTerms& terms, const CrankAngles& accelerations);

/// Forward dynamics: the accelerations of the cranks [rad/s²] for given torques [N m].
CrankAngles accelerationsFrom(const PlatformTerms& terms, const CrankAngles& torques);

/// Kinetic energy [J], summed over the bodies by their own velocities.
double kineticEnergy(const PlatformState& state, const PlatformRates& rates, const PlatformInertia& inertia);

/// Potential energy [J]; zero if all masses are at the origin of the base.
double potentialEnergy(const MetricPlatform& platform, const PlatformState& state,
                       const PlatformInertia& inertia);

}  // namespace lamina
