// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/machine_transforms.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace {

using lamina::JointPositions;
using lamina::MachineTransforms;
using Transforms = std::vector<geometry_msgs::TransformStamped>;

const JointPositions kPositions = {{"x", 0.010}, {"y", 0.020}, {"z", 0.030},
                                   {"a", 0.0},   {"b", 0.0},   {"c", 0.0}};

Eigen::Isometry3d isometry(const geometry_msgs::Transform& t) {
  return Eigen::Translation3d(t.translation.x, t.translation.y, t.translation.z) *
         Eigen::Quaterniond(t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z);
}

/// root_from_link, as tf chains what is published; links above the root end the chain.
Eigen::Isometry3d rootFrom(std::string link, const Transforms& transforms) {
  Eigen::Isometry3d root_from_link = Eigen::Isometry3d::Identity();
  for (bool is_found = true; is_found;) {
    is_found = false;
    for (const auto& each : transforms) {
      if (each.child_frame_id != link) continue;
      root_from_link = isometry(each.transform) * root_from_link;
      link = each.header.frame_id;
      is_found = true;
      break;
    }
  }
  return root_from_link;
}

Transforms allOf(const MachineTransforms& machine) {
  Transforms all = machine.fixed(ros::Time());
  const Transforms moving = machine.moving(kPositions, ros::Time());
  all.insert(all.end(), moving.begin(), moving.end());
  return all;
}

TEST(MachineTransforms, OfEveryMachineBringTheNozzleToItsAxisValuesOverTheBed) {
  for (const std::string& name : lamina::machineNames()) {
    const lamina::CartesianMachine described = lamina::machineByName(name);
    const Transforms all = allOf(MachineTransforms(described.urdf));
    const Eigen::Isometry3d bed_from_nozzle = rootFrom("bed", all).inverse() * rootFrom("nozzle", all);
    const Eigen::Vector3d expected_mm = lamina::bedFromNozzle(described, {10.0, 20.0, 30.0}).translation();
    EXPECT_TRUE((1e3 * bed_from_nozzle.translation()).isApprox(expected_mm, 1e-9)) << name;
  }
}

TEST(MachineTransforms, OfEveryKinematicModelBringTheNozzleToWhereItsJointsDo) {
  for (const std::string& name : lamina::kinematicModelNames()) {
    const auto model = lamina::kinematicModelByName(name);
    const MachineTransforms machine(model->urdf());
    lamina::JointValues values = lamina::JointValues::Zero(static_cast<int>(model->joints().size()));
    for (Eigen::Index j = 0; j < values.size(); ++j) {
      const lamina::DrivenJoint& joint = model->joints()[static_cast<std::size_t>(j)];
      const double wanted = joint.kind == lamina::JointKind::Linear ? 20.0 + 7.0 * j : 0.1 + 0.03 * j;
      values[j] = std::clamp(wanted, joint.low, joint.high);
    }
    Transforms all = machine.fixed(ros::Time());
    const Transforms moving = machine.moving(machine.positions(model->urdfJoints(values)), ros::Time());
    all.insert(all.end(), moving.begin(), moving.end());
    Eigen::Isometry3d published = rootFrom("bed", all).inverse() * rootFrom("nozzle", all);
    published.translation() *= 1e3;
    EXPECT_TRUE(published.isApprox(model->bedFromNozzle(values), 1e-9)) << name;
  }
}

TEST(MachineTransforms, OfTheDropPrinterMoveTheTableAndNeverTheNozzle) {
  const MachineTransforms machine(lamina::machineByName("drop_printer").urdf);
  const Transforms fixed = machine.fixed(ros::Time());
  const Eigen::Isometry3d base_from_nozzle = rootFrom("nozzle", fixed);
  EXPECT_TRUE(base_from_nozzle.isApprox(rootFrom("nozzle", allOf(machine)), 1e-12));
  // The table stands where the nozzle's place less the position of the drop says.
  const Eigen::Vector3d table = rootFrom("bed", allOf(machine)).translation();
  EXPECT_TRUE(table.isApprox(base_from_nozzle.translation() - Eigen::Vector3d(0.010, 0.020, 0.030), 1e-9));
}

TEST(MachineTransforms, RefusePositionsThatLackAnAxis) {
  const MachineTransforms machine(lamina::machineByName("drop_printer").urdf);
  EXPECT_THROW(machine.moving({{"x", 0.0}, {"y", 0.0}}, ros::Time()), lamina::InvalidInput);
}

}  // namespace
