// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/platform/rus_workspace.hpp"

#include <cmath>
#include <cstdio>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-9;  // rad

std::string degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", kDegreesPerRadian * angle);
  return text;
}

std::string beyond(const std::string& what, double angle, double limit) {
  return what + " at " + degrees(angle) + " deg; it goes to " + degrees(limit) + " deg";
}

bool isWithin(double angle, double low, double high) {
  return angle >= low - kRounding && angle <= high + kRounding;
}

void addFaults(const RusLeg& leg, std::size_t index, const Eigen::Isometry3d& pose,
               std::vector<FaultyLeg>& faults) {
  const std::string name = "leg " + std::to_string(index + 1) + ": ";
  const Point3 ball = pose * leg.ball;
  const auto crank = crankAngle(leg, ball, leg.branch);
  if (!crank) {
    faults.push_back({index, LegFault::OutOfReach,
                      name + "the ball would be " + numberText((ball - leg.motor).norm()) +
                          " mm from the motor, where crank and coupler of " + numberText(leg.crank_mm) +
                          " and " + numberText(leg.coupler_mm) + " mm cannot hold it"});
    return;
  }
  if (!isWithin(*crank, leg.low, leg.high))
    faults.push_back({index, LegFault::Crank,
                      name + "the crank would be at " + degrees(*crank) + " deg; it goes from " +
                          degrees(leg.low) + " to " + degrees(leg.high) + " deg"});
  const PassiveAngles angles = passiveAngles(leg, pose, *crank);
  if (!isWithin(std::abs(angles.lean), 0.0, leg.greatest_lean))
    faults.push_back({index, LegFault::Universal,
                      name + beyond("the universal joint would lean", angles.lean, leg.greatest_lean)});
  if (!isWithin(angles.swing, 0.0, leg.greatest_swing))
    faults.push_back({index, LegFault::Spherical,
                      name + beyond("the spherical joint would swing", angles.swing, leg.greatest_swing)});
}

}  // namespace

PassiveAngles passiveAngles(const RusLeg& leg, const Eigen::Isometry3d& pose, double crank) {
  const Point3 coupler = (pose * leg.ball - leg.elbow(crank)).normalized();
  const double along = coupler.dot(leg.crankDirection(crank));
  const double across = coupler.dot(leg.crankTangent(crank));
  const Point3 from_ball = pose.linear().transpose() * -coupler;
  return {std::atan2(across, along), std::atan2(coupler.dot(leg.axis), std::hypot(along, across)),
          angleBetween(leg.socket, from_ball)};
}

std::vector<FaultyLeg> faultyLegs(const RusPlatform& platform, const Eigen::Isometry3d& pose) {
  std::vector<FaultyLeg> faults;
  for (std::size_t i = 0; i < kLegs; ++i) addFaults(platform.legs[i], i, pose, faults);
  return faults;
}

bool arePassiveJointsWithin(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                            const CrankAngles& cranks) {
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = platform.legs[i];
    const PassiveAngles angles = passiveAngles(leg, pose, cranks[static_cast<Eigen::Index>(i)]);
    if (!isWithin(std::abs(angles.lean), 0.0, leg.greatest_lean)) return false;
    if (!isWithin(angles.swing, 0.0, leg.greatest_swing)) return false;
  }
  return true;
}

}  // namespace lamina
