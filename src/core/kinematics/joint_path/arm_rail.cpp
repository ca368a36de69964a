// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/arm_rail.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/arm/six_axis_arm.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kParallelAxes = 1e-9;            // squared sine
constexpr double kOffRightAngle = 1.0 * kDegree;  // of a rail to axis 1
constexpr std::size_t kArmAxes = 6;               // before the external ones

/// The point of an axis that is nearest to another axis; any one of parallel axes.
Point3 pointNearestTo(const Screw& axis, const Screw& other) {
  const Point3 between = other.point - axis.point;
  const double cosine = axis.direction.dot(other.direction);
  const double square_sine = 1.0 - cosine * cosine;
  if (square_sine < kParallelAxes) return axis.point;
  const double along = (axis.direction.dot(between) - cosine * other.direction.dot(between)) / square_sine;
  return axis.point + along * axis.direction;
}

double distanceFromScrew(const Screw& axis, const Point3& point) {
  return Eigen::ParametrizedLine<double, 3>(axis.point, axis.direction).distance(point);
}

[[noreturn]] void refuseRail(const std::string& arm, const std::string& what) {
  throw InvalidConfig("arm '" + arm + "': " + what +
                      "; joints.rail follow or steps expects one rail that carries the arm");
}

/// The lengths of an arm, from its axes with all joints at zero.
void measureArm(ArmRail& rail, const SerialChain& arm) {
  const std::vector<Screw>& axes = arm.screws;
  rail.up = axes[0].direction;
  rail.centre = pointNearestTo(axes[0], axes[1]);
  rail.shoulder_mm = distanceFromScrew(axes[1], rail.centre);
  const Point3 bend = pointNearestTo(axes[4], axes[3]);
  const Point3 wrist = pointNearestTo(axes[5], axes[4]);
  rail.reach_mm = distanceFromScrew(axes[1], axes[2].point) + distanceFromScrew(axes[2], bend);
  const Point3 in_nozzle = arm.bed_from_nozzle_at_zero.inverse() * wrist;
  rail.wrist_mm = -in_nozzle.z();
  rail.slack_mm = in_nozzle.head<2>().norm() + (wrist - bend).norm() +
                  std::abs(axes[1].direction.dot(bend - rail.centre));
}

void setRailWay(ArmRail& rail) {
  const Point3& direction = rail.external.screws[static_cast<std::size_t>(rail.in_external)].direction;
  const double off = std::asin(std::min(1.0, std::abs(direction.dot(rail.up))));
  if (off > kOffRightAngle)
    refuseRail(rail.arm, "joint '" + rail.joint + "' runs " + angleText(off) +
                             " off a right angle to axis 1, more than 1 deg");
  rail.along = (direction - direction.dot(rail.up) * rail.up).normalized();
}

}  // namespace

ArmRail armRail(const KinematicModel& model) {
  const SixAxisArm& arm = requireSixAxisArm(model);
  const ArmChain& chain = arm.chain();
  ArmRail rail;
  rail.arm = arm.name();
  rail.external = chain.external;
  rail.external_in_station.reserve(chain.external_index.size());
  for (const Eigen::Index in_model : chain.external_index)
    rail.external_in_station.push_back(static_cast<std::size_t>(in_model) - kArmAxes);
  const std::vector<JointRange> ranges = jointRanges(rail.external.joints);
  const auto linear =
      std::count_if(ranges.begin(), ranges.end(), [](const JointRange& range) { return !range.is_rotary; });
  if (linear != 1) refuseRail(rail.arm, "has " + std::to_string(linear) + " linear external axes");
  if (ranges.back().is_rotary)
    refuseRail(rail.arm, "its linear external axis carries '" + rail.external.joints.back().name + "'");
  rail.in_external = static_cast<Eigen::Index>(ranges.size()) - 1;
  rail.joint = rail.external.joints.back().name;
  rail.in_station = rail.external_in_station.back();
  rail.range = ranges.back();
  measureArm(rail, chain.arm);
  setRailWay(rail);
  return rail;
}

}  // namespace lamina
