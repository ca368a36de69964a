// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {

/// Reasons why a leg of a platform cannot reach a pose.
enum class LegFault : std::uint8_t {
  OutOfReach,  ///< the ball is nearer or farther than crank and coupler reach
  Crank,       ///< the crank would leave its range
  Universal,   ///< the coupler would lean too far out of the plane of its crank
  Spherical,   ///< the coupler would swing too far from the middle of its spherical joint
};

struct FaultyLeg {
  std::size_t leg = 0;  ///< from 0
  LegFault fault = LegFault::OutOfReach;
  std::string reason;  ///< names the leg from 1, the value and the limit
};

/// Angles of a leg's passive joints.
struct PassiveAngles {
  double fold = 0.0;   ///< between coupler and crank, about the parallel to the motor's axis [rad]
  double lean = 0.0;   ///< of the coupler out of the crank's plane, positive along the motor's axis [rad]
  double swing = 0.0;  ///< of the coupler from the middle of the spherical joint's range, not negative [rad]
};
PassiveAngles passiveAngles(const RusLeg& leg, const Eigen::Isometry3d& pose, double crank);

/// Workspace check: all faults of the legs at a pose; empty if the platform can reach it.
/// @param pose  base_from_platform [mm]
std::vector<FaultyLeg> faultyLegs(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// Whether the passive joints of all legs are within their ranges at a pose, with the angles of the cranks
/// known.
bool arePassiveJointsWithin(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                            const CrankAngles& cranks);

}  // namespace lamina
