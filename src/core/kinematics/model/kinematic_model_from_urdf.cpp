// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/arm/arm_model.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/machine_urdf.hpp"
#include "kinematics/model/multi_axis_machine.hpp"
#include "kinematics/model/robot_kind.hpp"
#include "kinematics/platform/rus_from_urdf.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

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
  if (model->getJoint(kAxisNames[0])) return multiAxisMachine(*model, text);
  const std::optional<std::string> kind = robotKind(*model);
  if (kind == "arm") return armModel(*model, text);
  if (kind == "platform") return rusKinematicModel(*model, text);
  throw InvalidConfig("machine '" + model->getName() +
                      "' is of no kind that is recognised; expected a joint x, a joint " + kPlatformJoint +
                      ", or three rotary joints or more between root and link 'nozzle'");
}

}  // namespace lamina
