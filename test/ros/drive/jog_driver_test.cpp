// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/jog_driver.hpp"

#include <actionlib/server/simple_action_server.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "lamina/base/error.hpp"
#include "names.hpp"
#include "ros/set_time.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

using ActionGoal = follow::Action::_action_goal_type;
using test::waitUntil;

DriverSettings uncheckedSettings() {
  DriverSettings settings;
  settings.is_clearance_checked = false;
  settings.jog.reaction_s = 0.5;  // for loaded machines: orders that are late are not followed
  settings.jog.lease_s = 2.0;
  return settings;
}

/// A machine that is jogged by the test, which is its controller and its clock.
class JoggedMachine {
 public:
  JoggedMachine() {
    // All goals, also those that a simple server takes for older than others.
    const boost::function<void(const boost::shared_ptr<const ActionGoal>&)> on_goal =
        [this](const auto& goal) { begins.push_back(goal->goal.trajectory.header.stamp); };
    goals_ = node_.subscribe<ActionGoal>("follow_joint_trajectory/goal", 100, on_goal);
    server_.start();
    ros::AsyncSpinner spinner(1);
    spinner.start();
    controller_.requirePresent(test::kPatience);
    spinner.stop();
    for (const DrivenJoint& joint : model_->joints()) {
      at_.name.push_back(joint.name);
      at_.position.push_back(0.1);
    }
    order_.name = {model_->joints()[0].name};
    order_.velocity = {0.01};
    waitUntil([&] {
      return goals_.getNumPublishers() > 0 && states_.getNumSubscribers() > 0 &&
             orders_.getNumSubscribers() > 0;
    });
  }

  /// Joints that have been at rest for long, at a time.
  void restAt(double time_s) {
    for (const double time : {time_s - 0.3, time_s - 0.15, time_s}) {
      time_.set(time);
      states_.publish(at_);
      waitUntil([&] { return areHeardAt(time); });
    }
  }
  /// Gives an order until the controller has a goal for it.
  bool isFollowed() {
    const std::size_t before = begins.size();
    return waitUntil([&] {
      states_.publish(at_);
      orders_.publish(order_);
      return begins.size() > before;
    });
  }

  std::vector<ros::Time> begins;  ///< of the goals' motions

 private:
  bool areHeardAt(double time_s) const {
    try {
      joints_.fresh(0.01, 0.0);
      return ros::Time::now() == ros::Time(time_s);
    } catch (const TimedOut&) {
      return false;
    }
  }

  ros::NodeHandle node_{"jog_driver"};
  const DriverSettings settings_ = uncheckedSettings();
  const std::unique_ptr<const KinematicModel> model_ = kinematicModelOf(settings_.machine);
  actionlib::SimpleActionServer<follow::Action> server_{node_, names::kFollowJointTrajectory, false};
  ControllerClient controller_{node_, *model_, [](const ControllerReport&) {}};
  ProcessPublisher process_{node_};
  PresentJoints joints_{node_, *model_};
  ros::Subscriber goals_;
  ros::Publisher states_ = node_.advertise<sensor_msgs::JointState>(names::kJointStates, 10);
  ros::Publisher orders_ = node_.advertise<sensor_msgs::JointState>(names::kJogJoints, 10);
  sensor_msgs::JointState at_, order_;
  JogDriver jog_{node_, settings_, *model_, ExecutorOwner(""),
                 JogLinks{controller_, process_, joints_, [] { return Eigen::Matrix3d::Identity(); },
                          [](const JointValues&) {}}};
  const test::SetTime time_;
};

TEST(JogDriver, BeginsAnewWhereRosTimeWentBack) {
  JoggedMachine machine;
  machine.restAt(5000.0);
  ASSERT_TRUE(machine.isFollowed());
  EXPECT_GE(machine.begins.back(), ros::Time(5000.0));
  machine.restAt(4000.0);
  ASSERT_TRUE(machine.isFollowed());
  EXPECT_LT(machine.begins.back(), ros::Time(4001.0)) << "not when the former time has come again";
}

}  // namespace
}  // namespace lamina
