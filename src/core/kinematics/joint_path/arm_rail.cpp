// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/arm_rail.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kinematics/arm/six_axis_arm.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kParallelAxes = 1e-9;            // squared sine
constexpr double kOffRightAngle = 1.0 * kDegree;  // of a rail to axis 1
constexpr double kLeastAcross = 0.5;              // sine between two axes of a gantry
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
  throw InvalidConfig(
      "arm '" + arm + "': " + what +
      "; joints.rail follow or steps expects one rail that carries the arm, or follow a gantry that does");
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

enum class RailWay : std::uint8_t { Level, Upright };

RailWay wayOf(const ArmRail& rail, Eigen::Index joint) {
  const Point3& direction = rail.external.screws[static_cast<std::size_t>(joint)].direction;
  const double off = std::asin(std::min(1.0, std::abs(direction.dot(rail.up))));
  if (off <= kOffRightAngle) return RailWay::Level;
  const auto& joints = rail.external.joints;
  const bool is_gantry = joints.size() > 1 && joints[joints.size() - 2].kind == JointKind::Linear;
  if (is_gantry && off >= 0.5 * M_PI - kOffRightAngle) return RailWay::Upright;
  refuseRail(rail.arm, "joint '" + joints[static_cast<std::size_t>(joint)].name + "' runs " + angleText(off) +
                           " off a right angle to axis 1, more than 1 deg");
}

Point3 levelWay(const ArmRail& rail, Eigen::Index joint) {
  const Point3& direction = rail.external.screws[static_cast<std::size_t>(joint)].direction;
  return (direction - direction.dot(rail.up) * rail.up).normalized();
}

/// Those that carry the arm, from the bed on.
std::vector<Eigen::Index> levelAxes(const ArmRail& rail, const std::vector<JointRange>& ranges) {
  const auto linear =
      std::count_if(ranges.begin(), ranges.end(), [](const JointRange& range) { return !range.is_rotary; });
  if (linear == 0) refuseRail(rail.arm, "has 0 linear external axes");
  std::vector<Eigen::Index> level;
  for (std::size_t j = 0; j < ranges.size(); ++j) {
    if (ranges[j].is_rotary) continue;
    const auto carried = std::find_if(ranges.begin() + static_cast<std::ptrdiff_t>(j), ranges.end(),
                                      [](const JointRange& range) { return range.is_rotary; });
    if (carried != ranges.end())
      refuseRail(rail.arm, "its linear external axis carries '" +
                               rail.external.joints[static_cast<std::size_t>(carried - ranges.begin())].name +
                               "'");
    if (wayOf(rail, static_cast<Eigen::Index>(j)) == RailWay::Level)
      level.push_back(static_cast<Eigen::Index>(j));
  }
  if (level.empty()) refuseRail(rail.arm, "has no linear external axis at a right angle to axis 1");
  return level;
}

/// The longest one is the rail, all others are across it.
void setAxes(ArmRail& rail, const std::vector<JointRange>& ranges) {
  const std::vector<Eigen::Index> level = levelAxes(rail, ranges);
  const auto length = [&](Eigen::Index j) {
    const JointRange& range = ranges[static_cast<std::size_t>(j)];
    return range.high - range.low;
  };
  rail.in_external = *std::max_element(level.begin(), level.end(),
                                       [&](Eigen::Index a, Eigen::Index b) { return length(a) < length(b); });
  const auto main = static_cast<std::size_t>(rail.in_external);
  rail.joint = rail.external.joints[main].name;
  rail.in_station = rail.external_in_station[main];
  rail.range = ranges[main];
  rail.along = levelWay(rail, rail.in_external);
  for (const Eigen::Index j : level) {
    if (j == rail.in_external) continue;
    const auto index = static_cast<std::size_t>(j);
    const double aside = rail.up.cross(rail.along).dot(levelWay(rail, j));
    if (!rail.across.empty() || std::abs(aside) < kLeastAcross)
      refuseRail(rail.arm, "joints '" + rail.joint + "' and '" + rail.external.joints[index].name +
                               "' carry it the same way");
    rail.across.push_back(
        {rail.external.joints[index].name, rail.external_in_station[index], ranges[index], aside});
  }
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
  measureArm(rail, chain.arm);
  setAxes(rail, jointRanges(rail.external.joints));
  return rail;
}

}  // namespace lamina
