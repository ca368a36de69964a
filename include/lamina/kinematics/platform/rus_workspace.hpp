// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {

/// What keeps a leg of a platform from a pose.
enum class LegFault : std::uint8_t {
  OutOfReach,  ///< the ball is nearer or further than crank and coupler reach
  Crank,       ///< the crank would leave its range
  Universal,   ///< the coupler would lean too far out of the plane of its crank
  Spherical,   ///< the coupler would swing too far from the middle of its spherical joint
};

struct FaultyLeg {
  std::size_t leg = 0;  ///< from 0
  LegFault fault = LegFault::OutOfReach;
  std::string reason;  ///< names the leg from 1, the value and the limit
};

/// How the passive joints of a leg stand.
struct PassiveAngles {
  double fold = 0.0;   ///< of the coupler about the parallel of the motor's axis, from the crank [rad]
  double lean = 0.0;   ///< of the coupler out of the plane of the crank, positive along the axis [rad]
  double swing = 0.0;  ///< of the coupler from the middle of the spherical joint, not negative [rad]
};
PassiveAngles passiveAngles(const RusLeg& leg, const Eigen::Isometry3d& pose, double crank);

/// Workspace check: everything that keeps the platform from a pose; empty if it can be there.
/// @param pose  base_from_platform [mm]
std::vector<FaultyLeg> faultyLegs(const RusPlatform& platform, const Eigen::Isometry3d& pose);

/// The same for the passive joints alone, with the cranks known.
bool arePassiveJointsWithin(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                            const CrankAngles& cranks);

}  // namespace lamina
