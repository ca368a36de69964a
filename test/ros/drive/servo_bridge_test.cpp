// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Leads an emulated robot by the node servo_bridge: one in the node for a driven part, one in the test for
// all that goes wrong.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "follow_joint_trajectory.hpp"
#include "joint_messages.hpp"
#include "lamina/servo/emulated_robot.hpp"
#include "ros/drive/drive_cell.hpp"
#include "ros/drive/two_beads.hpp"
#include "ros/node_process.hpp"

namespace lamina {
namespace {

using test::DriveCell;
using test::NodeProcess;
using test::waitUntil;
using GoalState = actionlib::SimpleClientGoalState;

constexpr double kStart = 0.1;  // rad, of the first joint

JointValues standing() {
  JointValues joints = JointValues::Zero(6);
  joints[0] = kStart;
  return joints;
}

/// A robot within the test, with a node that leads it and a client of that.
class LedRobot {
 public:
  explicit LedRobot(std::vector<std::string> more = {})
      : robot({}, standing()), space_("/led_" + std::to_string(++robots)), node_(space_) {
    std::vector<std::string> arguments{"__ns:=" + space_,
                                       "_machine/name:=irb_4600",
                                       "_robot/host:=127.0.0.1",
                                       "_robot/script_port:=" + std::to_string(robot.port()),
                                       "_robot/port:=0",
                                       "_robot/report_silence_s:=60",
                                       "_cyclic/late_cycles:=100000",
                                       "_report_hz:=100"};
    bool is_patient = true;
    for (const std::string& one : more) is_patient = is_patient && one.find("silence_s") == std::string::npos;
    if (is_patient) more.emplace_back("_servoj/silence_s:=60");
    arguments.insert(arguments.end(), more.begin(), more.end());
    bridge = std::make_unique<NodeProcess>(LAMINA_BRIDGE_NODE, arguments);
    client_ = std::make_unique<Client>(node_, names::kFollowJointTrajectory, false);
    const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_position =
        [this](const auto& message) { heard = *message; };
    position_ = node_.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 100, on_position);
  }
  bool isReady() {
    return waitUntil([&] { return client_->isServerConnected() && !heard.name.empty(); });
  }
  double first() const { return robot.report().position[0]; }

  follow::Goal goalOf(double from, double to, double duration_s) const {
    follow::Goal goal;
    goal.trajectory.joint_names = jointNames(*model_);
    for (const double place : {from, to}) {
      JointState point;
      point.position = JointValues::Zero(6);
      point.position[0] = place;
      point.velocity = point.acceleration = JointValues::Zero(6);
      goal.trajectory.points.push_back(toMessage(point, model_->joints()));
      goal.trajectory.points.back().time_from_start = ros::Duration(place == from ? 0.0 : duration_s);
    }
    return goal;
  }
  void send(const follow::Goal& goal) { client_->sendGoal(goal); }
  void cancel() { client_->cancelGoal(); }
  /// Sends a goal until it is on its way: robots that were stopped are there again a little later.
  bool beginsSlowly() {
    return waitUntil([&] {
      if (client_->getState() != GoalState::ACTIVE) send(goalOf(first(), first() + 1.0, 100.0));
      const double before = first();
      ros::WallDuration(0.2).sleep();
      ros::spinOnce();
      return first() > before + 1e-5;
    });
  }
  GoalState ends() {
    EXPECT_TRUE(waitUntil([&] { return client_->getState().isDone(); }));
    return client_->getState();
  }
  bool rests() {
    return waitUntil([&] { return robot.isAtRest(); });
  }
  /// At rest on the way of slow goals, before their end.
  void expectOnThePath() {
    ASSERT_TRUE(rests());
    EXPECT_GT(first(), kStart);
    EXPECT_LT(first(), kStart + 1.0);
    EXPECT_LT(robot.report().position.tail<5>().cwiseAbs().maxCoeff(), 1e-6);
  }
  std::string reason() const { return client_->getResult()->error_string; }
  std::int32_t code() const { return client_->getResult()->error_code; }

  EmulatedRobot robot;
  std::unique_ptr<NodeProcess> bridge;
  sensor_msgs::JointState heard;

 private:
  using Client = actionlib::SimpleActionClient<follow::Action>;

  static inline int robots = 0;
  std::unique_ptr<const KinematicModel> model_ = kinematicModelByName("irb_4600");
  std::string space_;
  ros::NodeHandle node_;
  std::unique_ptr<Client> client_;
  ros::Subscriber position_;
};

TEST(ServoBridge, IsDrivenThroughAPart) {
  DriveCell cell("driven", "irb_4600");
  ros::NodeHandle node("driven");
  sensor_msgs::JointState last;
  const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_position = [&](const auto& message) {
    last = *message;
  };
  const auto position = node.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 100, on_position);
  ASSERT_TRUE(waitUntil([&] { return !last.name.empty(); }));
  cell.drive(test::twoBeads());
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, lamina_msgs::Status::OK + 0) << cell.result().status.message;
  const auto tip = [&]() -> Point3 {
    JointValues joints(6);
    for (int j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < last.name.size(); ++i)
        if (last.name[i] == cell.model->joints()[static_cast<std::size_t>(j)].name)
          joints[j] = last.position[i];
    return cell.model->bedFromNozzle(joints).translation();
  };
  EXPECT_TRUE(waitUntil([&] { return (tip() - Point3(-test::kHalf, 35, test::kHeight)).norm() < 0.02; }))
      << tip().transpose();
}

TEST(ServoBridge, GoesWhereAGoalSaysAndReportsIt) {
  LedRobot led;
  ASSERT_TRUE(led.isReady());
  led.send(led.goalOf(kStart, kStart + 0.2, 1.0));
  EXPECT_EQ(led.ends(), GoalState::SUCCEEDED) << led.reason();
  EXPECT_TRUE(waitUntil([&] { return std::abs(led.first() - kStart - 0.2) < 1e-4; })) << led.first();
  EXPECT_TRUE(waitUntil([&] {
    for (std::size_t i = 0; i < led.heard.name.size(); ++i)
      if (std::abs(led.heard.position[i] - kStart - 0.2) < 1e-4) return true;
    return false;
  }));
  led.send(led.goalOf(0.0, 0.5, 1.0));
  EXPECT_EQ(led.ends(), GoalState::ABORTED);
  EXPECT_EQ(led.code(), follow::Result::INVALID_GOAL + 0);
  EXPECT_NE(led.reason().find("the first point is not where the robot is"), std::string::npos)
      << led.reason();
  EXPECT_EQ(led.bridge->end(SIGTERM), 0);
}

TEST(ServoBridge, BrakesWhenAGoalIsCancelled) {
  LedRobot led;
  ASSERT_TRUE(led.isReady());
  ASSERT_TRUE(led.beginsSlowly());
  led.cancel();
  EXPECT_EQ(led.ends(), GoalState::PREEMPTED);
  led.expectOnThePath();
}

TEST(ServoBridge, AbortsTheGoalWhenTheRobotIsStoppedAndLeadsItAgain) {
  LedRobot led;
  ASSERT_TRUE(led.isReady());
  ASSERT_TRUE(led.beginsSlowly());
  led.robot.stop();
  EXPECT_EQ(led.ends(), GoalState::ABORTED);
  EXPECT_EQ(led.reason(), "the robot has ended its program");
  led.expectOnThePath();
  EXPECT_TRUE(led.beginsSlowly());
}

TEST(ServoBridge, StopsOnThePathWhenItIsAskedToEnd) {
  LedRobot led;
  ASSERT_TRUE(led.isReady());
  ASSERT_TRUE(led.beginsSlowly());
  EXPECT_EQ(led.bridge->end(SIGTERM), 0);
  EXPECT_EQ(led.ends(), GoalState::ABORTED);
  EXPECT_EQ(led.reason(), "the node was ended");
  led.expectOnThePath();
  EXPECT_EQ(led.robot.report().state, ServojState::Ended);
}

TEST(ServoBridge, LeavesTheRobotToStopOnThePathWhenItIsKilled) {
  LedRobot led({"_servoj/silence_s:=1"});
  ASSERT_TRUE(led.isReady());
  ASSERT_TRUE(led.beginsSlowly());
  EXPECT_EQ(led.bridge->end(SIGKILL), -1);
  ASSERT_TRUE(waitUntil([&] { return led.robot.report().state == ServojState::Silent; }));
  led.expectOnThePath();
}

TEST(ServoBridge, AbortsTheGoalWhenTheRobotHasStoppedAfterASilence) {
  LedRobot led({"_servoj/silence_s:=1"});
  ASSERT_TRUE(led.isReady());
  ASSERT_TRUE(led.beginsSlowly());
  ::kill(led.bridge->id(), SIGSTOP);
  EXPECT_TRUE(waitUntil([&] { return led.robot.report().state == ServojState::Silent; }));
  led.expectOnThePath();
  ::kill(led.bridge->id(), SIGCONT);
  EXPECT_EQ(led.ends(), GoalState::ABORTED);
  EXPECT_EQ(led.reason().find("the robot "), 0U) << led.reason();
}

TEST(ServoBridge, AbortsTheGoalWhenAJointLeavesItsPath) {
  LedRobot led({"_path_tolerance:=0.0001"});
  ASSERT_TRUE(led.isReady());
  led.send(led.goalOf(kStart, kStart + 1.0, 10.0));
  EXPECT_EQ(led.ends(), GoalState::ABORTED);
  EXPECT_EQ(led.code(), follow::Result::PATH_TOLERANCE_VIOLATED + 0);
  EXPECT_NE(led.reason().find("off its path"), std::string::npos) << led.reason();
  led.expectOnThePath();
}

TEST(ServoBridge, LeadsNoMachineThatIsNoRobotOfSixJoints) {
  NodeProcess bridge(LAMINA_BRIDGE_NODE,
                     {"__ns:=/other", "_machine/name:=cartesian_gantry", "_robot/port:=0"});
  EXPECT_EQ(bridge.wait(), 1);
}

}  // namespace
}  // namespace lamina
