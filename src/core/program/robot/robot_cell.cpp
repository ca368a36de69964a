// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/robot_cell.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
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

/// Among the external joints; the arm has it.
std::size_t externalIndex(const KinematicModel& arm, const std::string& name) {
  std::size_t index = 0;
  for (const DrivenJoint& joint : arm.joints()) {
    if (joint.name == name) break;
    if (isExternal(joint.name)) ++index;
  }
  return index;
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

std::vector<ExternalEntry> robotExternals(const std::string& text) {
  const ExternalNaming naming{"robot_program.external_axes", "e", '1', "external_1=e2, or external_2=-e1+90"};
  std::vector<ExternalEntry> entries = externalEntries(text, naming);
  std::sort(entries.begin(), entries.end(),
            [](const ExternalEntry& a, const ExternalEntry& b) { return a.slot < b.slot; });
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (entries[k].slot != k)
      throw InvalidConfig(naming.setting + " names " + naming.nameOf(entries[k].slot) + " without " +
                          naming.nameOf(k) + "; expected e1, e2, ... without a gap");
  return entries;
}

std::string externalMismatch(const ControllerMap& map, const KinematicModel& arm) {
  if (map.external.empty()) return {};
  std::vector<std::string> joints;
  for (const DrivenJoint& joint : arm.joints())
    if (isExternal(joint.name)) joints.push_back(joint.name);
  const auto isNamed = [&](const std::string& joint) {
    return std::any_of(map.external.begin(), map.external.end(),
                       [&](const ExternalEntry& entry) { return entry.joint == joint; });
  };
  for (const ExternalEntry& entry : map.external)
    if (std::find(joints.begin(), joints.end(), entry.joint) == joints.end())
      return "name joint " + entry.joint + "; expected those of '" + arm.name() +
             "': " + (joints.empty() ? "it has none" : listed(joints));
  for (const std::string& joint : joints)
    if (!isNamed(joint))
      return "do not name joint " + joint + " of '" + arm.name() + "'; expected each external joint";
  return {};
}

std::vector<double> controllerAxes(const ControllerMap& map, const KinematicModel& arm,
                                   const JointValues& values) {
  std::vector<double> joints = externalAxes(arm, values);
  if (map.external.empty()) return joints;
  std::vector<double> axes;
  axes.reserve(joints.size());
  for (const ExternalEntry& entry : map.external)
    axes.push_back(entry.sign * joints[externalIndex(arm, entry.joint)] + entry.zero);
  return axes;
}

std::vector<JointKind> controllerAxisKinds(const ControllerMap& map, const KinematicModel& arm) {
  std::vector<JointKind> joints = externalAxisKinds(arm);
  if (map.external.empty()) return joints;
  std::vector<JointKind> kinds;
  kinds.reserve(joints.size());
  for (const ExternalEntry& entry : map.external) kinds.push_back(joints[externalIndex(arm, entry.joint)]);
  return kinds;
}

std::optional<JointValues> withControllerAxes(const ControllerMap& map, const KinematicModel& arm,
                                              const JointValues& values, const std::vector<double>& axes) {
  if (map.external.empty()) return withExternalAxes(arm, values, axes);
  if (axes.size() < map.external.size()) return std::nullopt;
  std::vector<double> joints(map.external.size(), 0.0);
  for (std::size_t k = 0; k < map.external.size(); ++k) {
    const ExternalEntry& entry = map.external[k];
    joints[externalIndex(arm, entry.joint)] = (axes[k] - entry.zero) / entry.sign;
  }
  return withExternalAxes(arm, values, joints);
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
  joints.external = controllerAxes(map, arm, values);
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
  return withSixJoints(arm, *withControllerAxes(map, arm, values, external), six);
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
