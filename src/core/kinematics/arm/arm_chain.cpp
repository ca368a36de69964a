// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/arm_chain.hpp"

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFewestJoints = 5;
constexpr std::size_t kMostArmJoints = 7;
constexpr std::size_t kMostExternal = 3;

[[noreturn]] void refuse(const SerialChain& chain, const std::string& what) {
  throw InvalidConfig(
      "arm '" + chain.name + "' " + what +
      "; expected five to seven rotary joints next to the nozzle, all others named external_1, ...");
}

void append(SerialChain& chain, const SerialChain& whole, std::size_t index) {
  chain.outward.push_back(static_cast<int>(chain.joints.size()));
  chain.joints.push_back(whole.joints[index]);
  chain.screws.push_back(whole.screws[index]);
}

}  // namespace

ArmChain armChain(SerialChain whole) {
  ArmChain split;
  for (const int j : whole.outward) {
    const auto index = static_cast<std::size_t>(j);
    const DrivenJoint& joint = whole.joints[index];
    const std::size_t count = split.arm.joints.size();
    if (isExternal(joint.name)) {
      if (count > 0) refuse(whole, "has joint '" + joint.name + "' beyond joints of the arm");
      append(split.external, whole, index);
      split.external_index.push_back(j);
      continue;
    }
    if (joint.kind != JointKind::Rotary) refuse(whole, "has a linear joint '" + joint.name + "'");
    if (count < kMostArmJoints) split.arm_index.push_back(j);
    append(split.arm, whole, index);
  }
  if (split.external.joints.size() > kMostExternal)
    throw InvalidConfig("arm '" + whole.name + "' has " + std::to_string(split.external.joints.size()) +
                        " external axes; expected 3 at most, those of a gantry and a positioner together");
  const std::size_t count = split.arm.joints.size();
  if (count < kFewestJoints || count > kMostArmJoints)
    refuse(whole, "has " + std::to_string(count) + " rotary joints");
  split.arm.bed_from_nozzle_at_zero = whole.bed_from_nozzle_at_zero;
  split.whole = std::move(whole);
  return split;
}

Eigen::Isometry3d withoutExternal(const ArmChain& chain, const Eigen::Isometry3d& bed_from_nozzle,
                                  const JointValues& values) {
  if (chain.external_index.empty()) return bed_from_nozzle;
  JointValues external(static_cast<Eigen::Index>(chain.external_index.size()));
  for (Eigen::Index j = 0; j < external.size(); ++j)
    external[j] = values[chain.external_index[static_cast<std::size_t>(j)]];
  return bedFromNozzle(chain.external, external).inverse() * bed_from_nozzle;
}

}  // namespace lamina
