// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node simulated_controller to follow points, as a client whose host is late would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <memory>
#include <string>
#include <vector>

#include "follow_joint_trajectory.hpp"
#include "joint_messages.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

using test::waitUntil;
using GoalState = actionlib::SimpleClientGoalState;

constexpr double kLong = 1.0;  // s of a goal

/// A client of a controller and its process.
class Controlled {
 public:
  explicit Controlled(const std::string& space)
      : node_(space), client_(node_, names::kFollowJointTrajectory, false) {
    process_ = node_.advertise<lamina_msgs::ProcessTrajectory>(names::kProcessTrajectory, 10);
    const boost::function<void(const lamina_msgs::ProcessStateConstPtr&)> on_state =
        [this](const auto& message) { states.push_back(*message); };
    state_ = node_.subscribe<lamina_msgs::ProcessState>(names::kProcessState, 0, on_state);
  }
  bool isReady() {
    return waitUntil(
        [&] { return client_.isServerConnected() && process_.getNumSubscribers() > 0 && !states.empty(); });
  }

  /// All joints from the middle to a place off it, or back, within `kLong`.
  void send(const ros::Time& begin, double from_mm, double to_mm) {
    follow::Goal goal;
    goal.trajectory.header.stamp = begin;
    goal.trajectory.joint_names = jointNames(*model_);
    for (const double off_mm : {from_mm, to_mm}) {
      JointState point;
      point.position.resize(static_cast<Eigen::Index>(model_->joints().size()));
      point.velocity = point.acceleration = JointValues::Zero(point.position.size());
      for (std::size_t j = 0; j < model_->joints().size(); ++j) {
        const DrivenJoint& joint = model_->joints()[j];
        point.position[static_cast<Eigen::Index>(j)] = 0.5 * (joint.low + joint.high) + off_mm;
      }
      goal.trajectory.points.push_back(toMessage(point, model_->joints()));
      goal.trajectory.points.back().time_from_start = ros::Duration(off_mm == from_mm ? 0.0 : kLong);
    }
    stamps.clear();
    client_.sendGoal(goal, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                     [this](const auto& feedback) { stamps.push_back(feedback->header.stamp); });
  }
  /// Flows all the time of a goal.
  void sendProcess(const ros::Time& begin) {
    lamina_msgs::ProcessTrajectory message;
    message.header.stamp = begin;
    message.valid_for = ros::Duration(kLong);
    message.points.resize(2);
    message.points[0].flow = message.points[1].flow = 1e-9;
    message.points[1].time_from_start = message.valid_for;
    process_.publish(message);
  }
  GoalState ends() {
    EXPECT_TRUE(waitUntil([&] { return client_.getState().isDone(); }));
    return client_.getState();
  }
  std::string reason() { return client_.getResult()->error_string; }
  /// Of process states since the index, those that flow.
  std::size_t flowing(std::size_t since) const {
    std::size_t count = 0;
    for (std::size_t i = since; i < states.size(); ++i) count += states[i].flow > 0.0 ? 1 : 0;
    return count;
  }

  std::vector<lamina_msgs::ProcessState> states;
  std::vector<ros::Time> stamps;  ///< of feedback of the last goal

 private:
  using Client = actionlib::SimpleActionClient<follow::Action>;

  std::unique_ptr<const KinematicModel> model_ = kinematicModelByName("cartesian_gantry");
  ros::NodeHandle node_;
  Client client_;
  ros::Publisher process_;
  ros::Subscriber state_;
};

TEST(SimulatedController, AGoalFromRestThatComesLateBeginsLateAndItsProcessWithIt) {
  Controlled controlled("patient");
  ASSERT_TRUE(controlled.isReady());
  const ros::Time begin = ros::Time::now() - ros::Duration(5.0);
  const std::size_t before = controlled.states.size();
  controlled.sendProcess(begin);
  controlled.send(begin, 0.0, 10.0);
  EXPECT_EQ(controlled.ends(), GoalState::SUCCEEDED) << controlled.reason();
  // 20 reports a second of 1 s, by the stamps of the goal.
  ASSERT_TRUE(waitUntil([&] { return controlled.flowing(before) >= 19; })) << controlled.flowing(before);
  ASSERT_GE(controlled.stamps.size(), 19U);
  EXPECT_LE(controlled.stamps.size(), 23U);
  EXPECT_NEAR((controlled.stamps.front() - begin).toSec(), 0.0, 0.051);
  EXPECT_NEAR((controlled.stamps[1] - controlled.stamps[0]).toSec(), 0.05, 1e-6);
}

TEST(SimulatedController, AGoalWaitsForItsProcess) {
  Controlled controlled("patient");
  ASSERT_TRUE(controlled.isReady());
  const ros::Time first = ros::Time::now();
  controlled.sendProcess(first);
  controlled.send(first, 10.0, 0.0);
  ASSERT_EQ(controlled.ends(), GoalState::SUCCEEDED) << controlled.reason();
  const ros::Time second = ros::Time::now();
  controlled.send(second, 0.0, 10.0);
  const ros::Time long_after = second + ros::Duration(2.0 * kLong);
  ASSERT_TRUE(waitUntil([&] { return ros::Time::now() > long_after; }));
  const std::size_t before = controlled.states.size();
  EXPECT_LE(controlled.stamps.size(), 2U) << "it has begun without its process";
  controlled.sendProcess(second);
  EXPECT_EQ(controlled.ends(), GoalState::SUCCEEDED) << controlled.reason();
  EXPECT_TRUE(waitUntil([&] { return controlled.flowing(before) >= 19; })) << controlled.flowing(before);
}

TEST(SimulatedController, AJointThatLeavesItsPathEndsTheGoal) {
  Controlled controlled("strict");
  ASSERT_TRUE(controlled.isReady());
  controlled.send(ros::Time(), 0.0, 20.0);
  EXPECT_EQ(controlled.ends(), GoalState::ABORTED);
  EXPECT_NE(controlled.reason().find("left its path by more than 1"), std::string::npos)
      << controlled.reason();
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulated_controller_test");
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
