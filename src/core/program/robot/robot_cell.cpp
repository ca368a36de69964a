// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include "lamina/base/angle.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/external_axes.hpp"

namespace lamina {
namespace {

constexpr double kSamePlaceOfBase = 1e-6;  // mm and parts of unit vectors

}  // namespace

ArmCell controllerCell(const KinematicModel& arm) {
  ArmCell cell = armCell(arm);
  if (cell.is_bed_carried) return cell;
  const auto count = static_cast<Eigen::Index>(arm.joints().size());
  const auto links = arm.bedFromLinks(JointValues::Zero(count));
  const auto base = links.find("base");
  if (base == links.end()) return cell;
  // One that joints move is none to count from.
  const auto moved = arm.bedFromLinks(JointValues::Constant(count, 0.1));
  if (!moved.at("base").isApprox(base->second, kSamePlaceOfBase)) return cell;
  cell.carrier_from_bed = base->second.inverse();
  return cell;
}

bool ControllerMap::isPlain() const {
  const ControllerMap plain;
  return signs == plain.signs && zeros_deg == plain.zeros_deg && joint_3_from_2 == 0.0;
}

ControllerJoints controllerJoints(const ControllerMap& map, const KinematicModel& arm,
                                  const JointValues& values) {
  const SixJoints six = sixJointsOf(arm, values);
  ControllerJoints joints;
  for (std::size_t j = 0; j < 6; ++j)
    joints.arm_deg[j] = map.signs[j] * toDegrees(six[static_cast<Eigen::Index>(j)]) + map.zeros_deg[j];
  joints.arm_deg[2] += map.joint_3_from_2 * joints.arm_deg[1];
  joints.external = externalAxes(arm, values);
  return joints;
}

JointValues armJoints(const ControllerMap& map, const KinematicModel& arm, const ControllerJoints& joints) {
  SixJoints six;
  for (std::size_t j = 0; j < 6; ++j) {
    const double coupled = j == 2 ? map.joint_3_from_2 * joints.arm_deg[1] : 0.0;
    six[static_cast<Eigen::Index>(j)] =
        toRadians((joints.arm_deg[j] - coupled - map.zeros_deg[j]) / map.signs[j]);
  }
  JointValues values = JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()));
  std::vector<double> external = joints.external;
  external.resize(arm.joints().size(), 0.0);
  return withSixJoints(arm, *withExternalAxes(arm, values, external), six);
}

}  // namespace lamina
