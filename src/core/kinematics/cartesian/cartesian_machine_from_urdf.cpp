// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <urdf_model/model.h>
#include <cmath>
#include <optional>
#include <string>

#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/machine_urdf.hpp"
#include "kinematics/model/multi_axis_machine.hpp"
#include "kinematics/model/robot_kind.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;   // in the metre of URDF
constexpr double kLeastVolume = 1e-3;  // of the box that three axes of length 1 span

using Model = urdf::ModelInterface;

MachineAxis axisOf(const Model& model, int index, const Point3& direction) {
  const auto joint = model.getJoint(kAxisNames[index]);
  if (!joint || !joint->limits || !(joint->limits->lower < joint->limits->upper))
    throw InvalidConfig("machine '" + model.getName() + "' has no prismatic joint '" + kAxisNames[index] +
                        "' with limits");
  if (!(joint->limits->velocity > 0.0))
    throw InvalidConfig("machine '" + model.getName() + "': the velocity of joint '" + joint->name + "' is " +
                        numberText(joint->limits->velocity) + " m/s; must be positive");
  MachineAxis axis;
  axis.name = kAxisNames[index];
  axis.direction = direction;
  axis.low_mm = kMillimetres * joint->limits->lower;
  axis.high_mm = kMillimetres * joint->limits->upper;
  axis.max_speed_mm_s = kMillimetres * joint->limits->velocity;
  return axis;
}

/// @throws InvalidConfig if it is an arm or platform
void requireLinearAxes(const Model& model) {
  const std::optional<std::string> kind = robotKind(model);
  if (!kind) return;
  throw InvalidConfig("machine '" + model.getName() + "' is a robot (" + *kind +
                      ") without linear axes x, y and z; expected one of " + listed(machineNames()) +
                      ", or a description with these axes");
}

}  // namespace

std::vector<std::string> machineNames() {
  std::vector<std::string> names;
  for (const MachineText& text : machineTexts()) names.emplace_back(text.name);
  return names;
}

CartesianMachine machineByName(const std::string& name) {
  for (const auto* texts : {&machineTexts(), &robotTexts()})
    for (const MachineText& text : *texts)
      if (text.name == name) return machineFromUrdf(std::string(text.urdf));
  throw InvalidConfig("machine.name is '" + name + "'; must be one of " + listed(machineNames()));
}

CartesianMachine machineFromUrdf(const std::string& text) {
  const auto model = parseMachine(text);
  requireLinearAxes(*model);
  const LinkMotion bed = motionOf(*model, "bed");
  const LinkMotion nozzle = motionOf(*model, "nozzle");
  const LinkMotion sensor = motionOf(*model, "sensor");
  if (nozzle.axes != sensor.axes)
    throw InvalidConfig("machine '" + model->getName() +
                        "': the sensor does not move as the nozzle does; expected both on the same link");
  const Eigen::Isometry3d bed_from_root = bed.root_from_link.inverse();
  const Eigen::Matrix3d directions = bed_from_root.linear() * (nozzle.axes - bed.axes);
  if (!(std::abs(directions.determinant()) > kLeastVolume))
    throw InvalidConfig("machine '" + model->getName() + "': the axes x, y and z do not span space");

  CartesianMachine machine;
  machine.name = model->getName();
  machine.urdf = text;
  for (int i = 0; i < 3; ++i)
    machine.axes[static_cast<std::size_t>(i)] = axisOf(*model, i, directions.col(i));
  machine.bed_from_nozzle_at_zero = bed_from_root * nozzle.root_from_link;
  machine.rotary_joints = bed.rotaries;
  machine.rotary_joints.insert(machine.rotary_joints.end(), nozzle.rotaries.begin(), nozzle.rotaries.end());
  if (!machine.rotary_joints.empty()) multiAxisMachine(*model, text);
  machine.nozzle_from_sensor = nozzle.root_from_link.inverse() * sensor.root_from_link;
  return machine;
}

}  // namespace lamina
