// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node simulated_controller to follow points, as a client whose host is late would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>

#include <memory>
#include <string>
#include <vector>

#include "follow_joint_trajectory.hpp"
#include "joint_messages.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/wait_until.hpp"

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
  void send(const ros::Time& begin, double from_mm, double to_mm) { send(goalOf(begin, from_mm, to_mm)); }
  follow::Goal goalOf(const ros::Time& begin, double from_mm, double to_mm) const {
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
    return goal;
  }
  void send(const follow::Goal& goal) {
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
    sendProcess(message);
  }
  void sendProcess(const lamina_msgs::ProcessTrajectory& message) { process_.publish(message); }
  GoalState ends() {
    EXPECT_TRUE(waitUntil([&] { return client_.getState().isDone(); }));
    return client_.getState();
  }
  std::string reason() { return client_.getResult()->error_string; }
  std::int32_t code() { return client_.getResult()->error_code; }
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
  ASSERT_TRUE(waitUntil([&] { return controlled.stamps.size() >= 19; })) << controlled.stamps.size();
  EXPECT_LE(controlled.stamps.size(), 23U);
  EXPECT_NEAR((controlled.stamps.front() - begin).toSec(), 0.0, 0.051);
  EXPECT_NEAR((controlled.stamps[1] - controlled.stamps[0]).toSec(), 0.05, 1e-6);
}

TEST(SimulatedController, ProcessValuesAreHeldForHalfASecondBehindTheirLastPoint) {
  Controlled controlled("patient");
  ASSERT_TRUE(controlled.isReady());
  const ros::Time begin = ros::Time::now();
  lamina_msgs::ProcessTrajectory message;
  message.header.stamp = begin;
  message.valid_for = ros::Duration(3600.0);
  message.points.resize(1);
  message.points[0].flow = 1e-9;
  controlled.sendProcess(message);
  controlled.send(begin, 10.0, 0.0);
  ASSERT_EQ(controlled.ends(), GoalState::SUCCEEDED) << controlled.reason();
  const ros::Time end = begin + ros::Duration(kLong);
  ASSERT_TRUE(waitUntil([&] { return controlled.states.back().header.stamp >= end; }));
  ros::Time last;
  for (const lamina_msgs::ProcessState& state : controlled.states)
    if (state.flow > 0.0) last = state.header.stamp;
  // 20 reports a second.
  EXPECT_LE((last - begin).toSec(), 0.5);
  EXPECT_GE((last - begin).toSec(), 0.5 - 0.051);
  // Back to where the next test begins.
  const ros::Time back = ros::Time::now();
  controlled.sendProcess(back);
  controlled.send(back, 0.0, 10.0);
  ASSERT_EQ(controlled.ends(), GoalState::SUCCEEDED) << controlled.reason();
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
  EXPECT_EQ(controlled.code(), follow::Result::PATH_TOLERANCE_VIOLATED + 0) << controlled.reason();
  EXPECT_NE(controlled.reason().find("off its path; expected 1 at most"), std::string::npos)
      << controlled.reason();
}

/// Each code of the action, of a controller whose joints trail by a second and that has no tolerance of its
/// own.
TEST(SimulatedController, GivesEachCodeOfTheActionForItsFault) {
  Controlled controlled("trailing");
  ASSERT_TRUE(controlled.isReady());
  const auto endsAs = [&](const follow::Goal& goal, std::int32_t code, const std::string& reason) {
    controlled.send(goal);
    EXPECT_EQ(controlled.ends(), code == 0 ? GoalState::SUCCEEDED : GoalState::ABORTED) << reason;
    EXPECT_EQ(controlled.code(), code) << reason << "; is " << controlled.reason();
    EXPECT_NE(controlled.reason().find(reason), std::string::npos) << controlled.reason();
  };
  const auto goal = [&] { return controlled.goalOf(ros::Time(), 0.0, 5.0); };
  follow::Goal unnamed = goal();
  unnamed.trajectory.joint_names[0] = "elbow";
  endsAs(unnamed, follow::Result::INVALID_JOINTS, "named 0 times");
  follow::Goal twice = goal();
  twice.trajectory.joint_names.push_back(twice.trajectory.joint_names[0]);
  endsAs(twice, follow::Result::INVALID_JOINTS, "named 2 times");
  follow::Goal foreign = goal();
  foreign.path_tolerance.resize(1);
  foreign.path_tolerance[0].name = "elbow";
  endsAs(foreign, follow::Result::INVALID_JOINTS, "a tolerance is of joint 'elbow'");
  endsAs(controlled.goalOf(ros::Time::now() - ros::Duration(60.0), 0.0, 5.0),
         follow::Result::OLD_HEADER_TIMESTAMP, "in the past");
  follow::Goal empty = goal();
  empty.trajectory.points.clear();
  endsAs(empty, follow::Result::INVALID_GOAL, "without points");
  follow::Goal far = controlled.goalOf(ros::Time(), 0.0, 1e5);
  endsAs(far, follow::Result::INVALID_GOAL, "a point is at joint");
  const std::string joint = goal().trajectory.joint_names[0];
  follow::Goal undefined = goal();
  undefined.goal_tolerance.resize(1);
  undefined.goal_tolerance[0].name = joint;
  undefined.goal_tolerance[0].position = std::nan("");
  endsAs(undefined, follow::Result::INVALID_GOAL, "a tolerance of joint '" + joint + "' is nan");
  follow::Goal tight = goal();
  tight.path_tolerance.resize(1);
  tight.path_tolerance[0].name = joint;
  tight.path_tolerance[0].position = 0.001;
  // It trails by some mm at the goal's time, and comes within 1 mm some seconds later.
  const ros::Duration settle(8.0);
  follow::Goal hasty = controlled.goalOf(ros::Time(), 0.0, 20.0);
  hasty.goal_tolerance = tight.path_tolerance;
  hasty.goal_time_tolerance = ros::Duration(0.3);
  endsAs(hasty, follow::Result::GOAL_TOLERANCE_VIOLATED, "off its goal");
  settle.sleep();
  follow::Goal patient = controlled.goalOf(ros::Time(), 20.0, 0.0);
  patient.goal_tolerance = hasty.goal_tolerance;
  patient.goal_time_tolerance = ros::Duration(30.0);
  endsAs(patient, follow::Result::SUCCESSFUL, "");
  follow::Goal any = controlled.goalOf(ros::Time(), 0.0, 5.0);
  any.goal_tolerance = hasty.goal_tolerance;
  any.goal_tolerance[0].position = -1.0;
  endsAs(any, follow::Result::SUCCESSFUL, "");
  settle.sleep();
  // The last: it ends on the way.
  tight.trajectory = controlled.goalOf(ros::Time(), 5.0, 20.0).trajectory;
  endsAs(tight, follow::Result::PATH_TOLERANCE_VIOLATED, "joint '" + joint + "'");
}

}  // namespace
}  // namespace lamina
