// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/arm/six_axis_arm.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/machine_urdf.hpp"
#include "kinematics/model/multi_axis_machine.hpp"
#include "kinematics/model/robot_kind.hpp"
#include "kinematics/platform/rus_from_urdf.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

/// A kind of kinematic model and the joint by which it is recognised.
struct Kind {
  const char* joint;
  std::unique_ptr<KinematicModel> (*read)(const urdf::ModelInterface& model, const std::string& text);
};

constexpr Kind kKinds[] = {
    {"x", multiAxisMachine},
    {kArmJoint, sixAxisArm},
    {kPlatformJoint, rusKinematicModel},
};

std::string listedKinds() {
  std::vector<std::string> joints;
  for (const Kind& kind : kKinds) joints.emplace_back(kind.joint);
  return listed(joints);
}

}  // namespace

std::vector<std::string> kinematicModelNames() {
  std::vector<std::string> names;
  for (const MachineText& text : machineTexts()) names.emplace_back(text.name);
  for (const MachineText& text : robotTexts()) names.emplace_back(text.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::unique_ptr<KinematicModel> kinematicModelByName(const std::string& name) {
  for (const auto* texts : {&machineTexts(), &robotTexts()})
    for (const MachineText& text : *texts)
      if (text.name == name) return kinematicModelFromUrdf(std::string(text.urdf));
  throw InvalidConfig("machine.name is '" + name + "'; must be one of " + listed(kinematicModelNames()));
}

std::unique_ptr<KinematicModel> kinematicModelFromUrdf(const std::string& text) {
  const auto model = parseMachine(text);
  for (const Kind& kind : kKinds)
    if (model->getJoint(kind.joint)) return kind.read(*model, text);
  throw InvalidConfig("machine '" + model->getName() +
                      "' has no joint by which its kind is recognised; expected one of " + listedKinds());
}

}  // namespace lamina
