// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "program/external_axes.hpp"

namespace lamina {
namespace {

constexpr double kSamePlaceOfBase = 1e-6;  // mm and parts of unit vectors
constexpr double kSameCount = 1e-6;        // deg, and shares

/// Nothing if the cell file says nothing of them.
void requireCounted(const char* what, const std::array<double, 6>& counted,
                    const std::vector<double>& stated) {
  const auto isSame = [](double a, double b) { return std::abs(a - b) <= kSameCount; };
  if (stated.empty() || std::equal(stated.begin(), stated.end(), counted.begin(), isSame)) return;
  const auto listed = [](const auto& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : " ") + numberText(number);
    return text;
  };
  throw InvalidProgram(std::string("the program counts joints with the ") + what + ' ' + listed(counted) +
                       "; expected " + listed(stated) + ", of cell.controller");
}

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

const char* controllerKind(RobotLanguage language) {
  switch (language) {
    case RobotLanguage::Krl:
      return "kuka";
    case RobotLanguage::UrScript:
      return "ur";
    case RobotLanguage::Fanuc:
      return "fanuc";
    case RobotLanguage::Inform:
      return "yaskawa";
  }
  return "";
}

void requireController(RobotLanguage language, const ControllerMap& map, const KinematicModel& arm) {
  requireControllerKind(arm.urdf(), controllerKind(language), toString(language));
  const std::optional<ArmController> stated = armController(arm.urdf());
  if (!stated) return;
  requireCounted("signs", map.signs, stated->signs);
  requireCounted("zeros [deg]", map.zeros_deg, stated->zeros_deg);
  const double share = stated->joint_3_from_2.value_or(map.joint_3_from_2);
  if (std::abs(share - map.joint_3_from_2) <= kSameCount) return;
  throw InvalidProgram("the program counts joint 3 with a share of joint 2 of " +
                       numberText(map.joint_3_from_2) + "; expected " + numberText(share) +
                       ", of cell.controller");
}

}  // namespace lamina
