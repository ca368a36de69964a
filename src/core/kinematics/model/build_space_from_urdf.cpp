// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <urdf_model/model.h>

#include <memory>
#include <string>

#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"
#include "kinematics/model/machine_urdf.hpp"
#include "kinematics/model/robot_kind.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

constexpr double kRobotHeight = 1500.0;  // mm: beyond what arms of 2 to 3 m do over a table

Box3 boxOfBodies(const urdf::Link& link) {
  Box3 box;
  for (const auto& collision : link.collision_array) {
    const BodyShape shape = shapeOf(*collision, link.name);
    const Eigen::Isometry3d pose = poseOf(collision->origin);
    for (int i = 0; i < 3; ++i) {
      const Point3 direction = pose.linear().transpose() * Point3::Unit(i);
      box.include(Point3(pose.translation() - extent(shape, -direction) * Point3::Unit(i)));
      box.include(Point3(pose.translation() + extent(shape, direction) * Point3::Unit(i)));
    }
  }
  return box;
}

BuildSpace spaceOverBed(const urdf::ModelInterface& model, const std::string& text) {
  const urdf::Link& bed = requireLink(model, "bed");
  if (bed.collision_array.empty())
    throw InvalidConfig("machine '" + model.getName() +
                        "': link 'bed' has no collision body; expected one of the size of the plate");
  BuildSpace space;
  space.name = model.getName();
  space.range = boxOfBodies(bed);
  space.range.low.z() = 0.0;
  space.range.high.z() = kRobotHeight;
  const std::unique_ptr<KinematicModel> robot = kinematicModelFromUrdf(text);
  for (const DrivenJoint& joint : robot->joints()) space.rotary_joints.push_back(joint.name);
  return space;
}

}  // namespace

BuildSpace buildSpaceByName(const std::string& name) {
  for (const auto* texts : {&machineTexts(), &robotTexts()})
    for (const MachineText& text : *texts)
      if (text.name == name) return buildSpaceFromUrdf(std::string(text.urdf));
  throw InvalidConfig("machine.name is '" + name + "'; must be one of " + listed(kinematicModelNames()));
}

BuildSpace buildSpaceFromUrdf(const std::string& text) {
  const auto model = parseMachine(text);
  return robotKind(*model) ? spaceOverBed(*model, text) : buildSpaceOf(machineFromUrdf(text));
}

}  // namespace lamina
