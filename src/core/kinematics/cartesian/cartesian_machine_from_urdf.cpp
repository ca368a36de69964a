// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <urdf_model/model.h>
#include <cmath>
#include <memory>
#include <string>

#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/machine_urdf.hpp"
#include "kinematics/model/multi_axis_machine.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

constexpr double kHeight = 1500.0;  // mm: beyond what arms of 2 to 3 m do over a table
constexpr double kSpeed = 1000.0;   // mm/s: of a tool, as robots' programs allow it

Box3 bedBox(const urdf::Link& bed) {
  Box3 box;
  for (const auto& collision : bed.collision_array) {
    const BodyShape shape = shapeOf(*collision, bed.name);
    const Eigen::Isometry3d pose = poseOf(collision->origin);
    for (int i = 0; i < 3; ++i) {
      const Point3 direction = pose.linear().transpose() * Point3::Unit(i);
      box.include(Point3(pose.translation() - extent(shape, -direction) * Point3::Unit(i)));
      box.include(Point3(pose.translation() + extent(shape, direction) * Point3::Unit(i)));
    }
  }
  return box;
}

/// Whether it is an arm or a platform, recognised by joint_1 or crank_1: no machine of axes x, y and z.
bool isRobot(const urdf::ModelInterface& model) {
  return !model.getJoint(kAxisNames[0]) && (model.getJoint("joint_1") || model.getJoint("crank_1"));
}

/// A robot as slicing and placing see it: the room over the bodies of its bed, in which axes along the bed's
/// carry an upright nozzle. A joint path shows what the robot reaches, and how.
/// @throws InvalidConfig if it has no link `bed`, or that no collision body
CartesianMachine roomOverBed(const urdf::ModelInterface& model, const std::string& text) {
  const auto bed = model.getLink("bed");
  if (!bed) throw InvalidConfig("machine '" + model.getName() + "' has no link 'bed'");
  if (bed->collision_array.empty())
    throw InvalidConfig("machine '" + model.getName() +
                        "': link 'bed' has no collision body; expected one of the size of the plate");
  const Box3 box = bedBox(*bed);
  CartesianMachine machine;
  machine.name = model.getName();
  machine.urdf = text;
  for (int i = 0; i < 3; ++i) {
    MachineAxis& axis = machine.axes[static_cast<std::size_t>(i)];
    axis.name = kAxisNames[i];
    axis.direction = Point3::Unit(i);
    axis.low_mm = i < 2 ? box.low[i] : 0.0;
    axis.high_mm = i < 2 ? box.high[i] : kHeight;
    axis.max_speed_mm_s = kSpeed;
  }
  machine.bed_from_nozzle_at_zero.linear() = nozzleDown().toRotationMatrix();
  const std::unique_ptr<KinematicModel> robot = kinematicModelFromUrdf(text);
  for (const DrivenJoint& joint : robot->joints()) machine.rotary_joints.push_back(joint.name);
  return machine;
}

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
                        std::to_string(joint->limits->velocity) + " m/s; must be positive");
  MachineAxis axis;
  axis.name = kAxisNames[index];
  axis.direction = direction;
  axis.low_mm = kMillimetres * joint->limits->lower;
  axis.high_mm = kMillimetres * joint->limits->upper;
  axis.max_speed_mm_s = kMillimetres * joint->limits->velocity;
  return axis;
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
  throw InvalidConfig("machine.name is '" + name + "'; must be one of " + listed(kinematicModelNames()));
}

CartesianMachine machineFromUrdf(const std::string& text) {
  const auto model = parseMachine(text);
  if (isRobot(*model)) return roomOverBed(*model, text);
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
