// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "lamina/dynamics/platform_inertia.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {

/// Velocity of a platform's origin [m/s], then its turn [rad/s], in the base frame.
using Twist = Eigen::Matrix<double, 6, 1>;

/// A platform with lengths in metres, as forces want them.
struct MetricPlatform {
  RusPlatform platform;  ///< every length in m
};
MetricPlatform inMetres(RusPlatform platform);

/// A platform in motion.
struct PlatformState {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [m]
  CrankAngles cranks = CrankAngles::Zero();                ///< those of the pose [rad]
  Twist twist = Twist::Zero();
};

/// How a platform and its legs go with its cranks: twist = `twist_from_rates` * dq/dt, and its derivative
/// `twist_from_rates` * d²q/dt² + `bias`.
struct PlatformRates {
  struct Leg {
    Point3 arm = Point3::Zero();      ///< ball from the platform's origin [m, base frame]
    Point3 crank = Point3::Zero();    ///< from motor to elbow [m]
    Point3 tangent = Point3::Zero();  ///< how the elbow goes with the crank [m/rad]
  };
  std::array<Leg, kLegs> legs;
  CrankAngles cranks = CrankAngles::Zero();  ///< dq/dt [rad/s]
  Matrix6 twist_from_rates = Matrix6::Zero();
  Twist bias = Twist::Zero();
};

/// At a singularity the result is not finite.
PlatformRates ratesOf(const MetricPlatform& platform, const PlatformState& state);

/// Terms of the equation of motion: torque = mass * d²q/dt² + coriolis + gravity + friction [N m].
struct PlatformTerms {
  Matrix6 mass = Matrix6::Zero();  ///< [kg m²]
  CrankAngles coriolis = CrankAngles::Zero();
  CrankAngles gravity = CrankAngles::Zero();
  CrankAngles friction = CrankAngles::Zero();

  CrankAngles withoutAcceleration() const { return coriolis + gravity + friction; }
};
PlatformTerms termsOf(const PlatformState& state, const PlatformRates& rates, const PlatformInertia& inertia);

/// Inverse dynamics: torques of the cranks [N m].
CrankAngles torquesFor(const PlatformTerms& terms, const CrankAngles& accelerations);

/// Forward dynamics: accelerations of the cranks [rad/s²].
CrankAngles accelerationsFrom(const PlatformTerms& terms, const CrankAngles& torques);

/// Summed over the bodies from their own velocities [J].
double kineticEnergy(const PlatformState& state, const PlatformRates& rates, const PlatformInertia& inertia);

/// Zero with all masses at the base's origin [J].
double potentialEnergy(const MetricPlatform& platform, const PlatformState& state,
                       const PlatformInertia& inertia);

}  // namespace lamina
