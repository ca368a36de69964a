// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Number of legs of a 6-RUS platform. Each is a chain of a revolute, a universal and a spherical joint: a
/// driven crank, a coupler on a universal joint at the crank's end, and a spherical joint at the mobile
/// platform.
constexpr std::size_t kLegs = 6;

/// Angles of the six cranks [rad].
using CrankAngles = Eigen::Matrix<double, 6, 1>;

/// The solution that a leg uses for its crank: the crank's angle compared with the angle of the line from the
/// motor to the ball, seen along the motor's axis.
enum class CrankBranch : std::uint8_t {
  Behind,  ///< smaller angle
  Ahead    ///< greater angle
};

/// One leg of a 6-RUS platform.
struct RusLeg {
  Point3 motor = Point3::Zero();  ///< centre of the crank's rotation [mm, base frame]
  Point3 axis = Point3::Zero();   ///< about which the crank turns, of unit length [base frame]
  /// Direction of the crank at angle 0, of unit length, perpendicular to the axis [base frame].
  Point3 rest = Point3::Zero();
  Point3 ball = Point3::Zero();  ///< centre of the spherical joint [mm, platform frame]
  /// Direction from which the coupler comes in the middle of the spherical joint's range, of unit length
  /// [platform frame].
  Point3 socket = Point3::Zero();
  double crank_mm = 0.0;
  double coupler_mm = 0.0;
  CrankBranch branch = CrankBranch::Ahead;  ///< branch in which it is built
  double low = 0.0;                         ///< least angle of the crank [rad]
  double high = 0.0;                        ///< greatest angle of the crank [rad]
  double greatest_lean = 0.0;   ///< of the coupler out of the plane in which the crank rotates [rad]
  double greatest_swing = 0.0;  ///< of the coupler away from `socket` [rad]

  /// End of the crank [mm, base frame].
  Point3 elbow(double crank) const { return motor + crank_mm * crankDirection(crank); }
  Point3 crankDirection(double crank) const {
    return std::cos(crank) * rest + std::sin(crank) * axis.cross(rest);
  }
  /// Derivative of `crankDirection` by the angle.
  Point3 crankTangent(double crank) const {
    return std::cos(crank) * axis.cross(rest) - std::sin(crank) * rest;
  }
};

/// Geometry of a 6-RUS platform. The base frame is that of the motors, its z up; the platform frame is that
/// of the platform's balls.
struct RusPlatform {
  std::array<RusLeg, kLegs> legs;
  Eigen::Isometry3d home = Eigen::Isometry3d::Identity();  ///< base_from_platform [mm]
};

/// Dimensions of the Hunt platform [Guacheta2021, table 1-1], and values that the thesis does not state
/// (docs/machines/platform.md has the reasons): the motors' directions, the branch, the home pose and the
/// joints' ranges.
struct HuntDimensions {
  double static_long_mm = 350.0;   ///< long edges of the hexagon of the motors
  double static_short_mm = 150.0;  ///< short edges of it
  double mobile_long_mm = 200.0;   ///< long edges of the hexagon of the balls
  double mobile_short_mm = 50.0;   ///< short edges of it
  double crank_mm = 150.0;
  double coupler_mm = 340.0;
  double home_drop_mm = 260.0;  ///< not published: height of the platform below the base in the home pose
  double crank_low = -1.2;      ///< not published [rad]
  double crank_high = 1.4;
  double greatest_lean = 1.05;   ///< not published: of the universal joints [rad]
  double greatest_swing = 1.31;  ///< not published: of the spherical joints [rad]
};

/// Distance of a hexagon's corners from its middle, if its edges are alternately `long_mm` and `short_mm`
/// long.
double hexagonRadius(double long_mm, double short_mm);

/// The Hunt platform. The base is above the platform. The motors of legs 1 and 2, 3 and 4, 5 and 6 are at the
/// ends of a short edge of the base, at about 0, 120 and 240 deg; each crank rotates in the vertical plane of
/// its long edge and points along that edge at angle 0.
/// @throws InvalidConfig if a dimension is not positive, or a leg cannot reach at home
RusPlatform huntPlatform(const HuntDimensions& dimensions = {});

}  // namespace lamina
