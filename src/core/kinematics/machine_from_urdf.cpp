// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>

#include "kinematics/machine_urdf.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/machine.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;  // in the metre of URDF
constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr double kUnit = 1e-6;
constexpr double kLeastVolume = 1e-3;  // of the box that three axes of length 1 span

using Model = urdf::ModelInterface;

Eigen::Isometry3d originOf(const urdf::Joint& joint) {
  const urdf::Pose& pose = joint.parent_to_joint_origin_transform;
  const Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return Eigen::Translation3d(kMillimetres * Point3(pose.position.x, pose.position.y, pose.position.z)) *
         rotation.normalized();
}

const urdf::Link& requireLink(const Model& model, const std::string& name) {
  const auto link = model.getLink(name);
  if (!link) throw InvalidConfig("machine '" + model.getName() + "' has no link '" + name + "'");
  return *link;
}

/// A link over the machine's root, with all axes at 0, and how it moves with each axis.
struct LinkMotion {
  Eigen::Isometry3d root_from_link = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< columns: root frame, per mm of x, y, z
};

int axisIndex(const Model& model, const urdf::Joint& joint) {
  for (int i = 0; i < 3; ++i)
    if (joint.type == urdf::Joint::PRISMATIC && joint.name == kAxisNames[i]) return i;
  throw InvalidConfig("machine '" + model.getName() + "': joint '" + joint.name +
                      "' moves; only prismatic joints x, y and z are understood");
}

/// Of a unit of the joint's value: anything but a unit vector would be a second scale beside the limits.
Point3 directionOf(const Model& model, const urdf::Joint& joint) {
  const Point3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (std::abs(axis.norm() - 1.0) < kUnit) return axis.normalized();
  throw InvalidConfig("machine '" + model.getName() + "': the axis of joint '" + joint.name + "' is " +
                      std::to_string(axis.norm()) + " long; expected 1");
}

LinkMotion motionOf(const Model& model, const std::string& name) {
  const urdf::Link* link = &requireLink(model, name);
  LinkMotion motion;
  while (link->parent_joint) {
    const urdf::Joint& joint = *link->parent_joint;
    const Eigen::Isometry3d origin = originOf(joint);
    motion.root_from_link = origin * motion.root_from_link;
    motion.axes = origin.linear() * motion.axes;
    if (joint.type != urdf::Joint::FIXED)
      motion.axes.col(axisIndex(model, joint)) = origin.linear() * directionOf(model, joint);
    link = &requireLink(model, joint.parent_link_name);
  }
  return motion;
}

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
  for (const MachineText& text : machineTexts()) names.push_back(text.name);
  return names;
}

Machine machineByName(const std::string& name) {
  for (const MachineText& text : machineTexts())
    if (text.name == name) return machineFromUrdf(text.urdf);
  throw InvalidConfig("machine.name is '" + name + "'; must be one of " + listed(machineNames()));
}

Machine machineFromUrdf(const std::string& text) {
  const auto model = urdf::parseURDF(text);
  if (!model)
    throw InvalidConfig("the machine's description of " + std::to_string(text.size()) + " bytes is no URDF");
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

  Machine machine;
  machine.name = model->getName();
  machine.urdf = text;
  for (int i = 0; i < 3; ++i)
    machine.axes[static_cast<std::size_t>(i)] = axisOf(*model, i, directions.col(i));
  machine.bed_from_nozzle_at_zero = bed_from_root * nozzle.root_from_link;
  machine.nozzle_from_sensor = nozzle.root_from_link.inverse() * sensor.root_from_link;
  return machine;
}

}  // namespace lamina
