// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/cartesian/bed_room.hpp"

#include <memory>

#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/error.hpp"
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

}  // namespace

bool isRobot(const urdf::ModelInterface& model) {
  return !model.getJoint(kAxisNames[0]) && (model.getJoint("joint_1") || model.getJoint("crank_1"));
}

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

}  // namespace lamina
