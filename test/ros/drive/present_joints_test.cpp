// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/present_joints.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "names.hpp"
#include "ros/set_time.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

/// Whether the joints were reported within half a second.
bool areFresh(const PresentJoints& joints) {
  try {
    joints.fresh(0.5, 0.0);
    return true;
  } catch (const TimedOut&) {
    return false;
  }
}

/// All joints of a model at 0.1 m or rad.
sensor_msgs::JointState reportOf(const KinematicModel& model) {
  sensor_msgs::JointState state;
  for (const DrivenJoint& joint : model.joints()) {
    state.name.push_back(joint.name);
    state.position.push_back(0.1);
  }
  return state;
}

TEST(PresentJoints, AreNotThoseOfBeforeRosTimeWentBack) {
  const test::SetTime time;
  time.set(5000.0);
  ros::NodeHandle node;
  const auto model = kinematicModelOf(MachineSettings());
  const PresentJoints joints(node, *model);
  const ros::Publisher reports = node.advertise<sensor_msgs::JointState>(names::kJointStates, 10);
  const sensor_msgs::JointState state = reportOf(*model);
  ASSERT_TRUE(test::waitUntil([&] { return reports.getNumSubscribers() > 0; }));
  reports.publish(state);
  ASSERT_TRUE(test::waitUntil([&] { return areFresh(joints); }));
  time.set(5001.0);
  EXPECT_FALSE(areFresh(joints));
  time.set(4000.0);
  EXPECT_FALSE(areFresh(joints)) << "nobody has reported them since";
  reports.publish(state);
  EXPECT_TRUE(test::waitUntil([&] { return areFresh(joints); }));
}

TEST(PresentJoints, AreNotStillOnceNobodyReportsThem) {
  const test::SetTime time;
  time.set(6000.0);
  ros::NodeHandle node;
  const auto model = kinematicModelOf(MachineSettings());
  const PresentJoints joints(node, *model);
  EXPECT_TRUE(joints.areStillFor(0.2)) << "never heard of";
  const ros::Publisher reports = node.advertise<sensor_msgs::JointState>(names::kJointStates, 10);
  const sensor_msgs::JointState state = reportOf(*model);
  ASSERT_TRUE(test::waitUntil([&] { return reports.getNumSubscribers() > 0; }));
  reports.publish(state);
  ASSERT_TRUE(test::waitUntil([&] { return areFresh(joints); }));
  time.set(6000.1);
  EXPECT_FALSE(joints.areStillFor(0.2)) << "for 0.1 s only";
  time.set(6000.3);
  EXPECT_FALSE(joints.areStillFor(0.2)) << "not heard of for 0.3 s";
  ASSERT_TRUE(test::waitUntil([&] {
    reports.publish(state);
    return joints.areStillFor(0.2);
  }));
}

}  // namespace
}  // namespace lamina
