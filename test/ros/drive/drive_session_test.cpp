// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/drive_session.hpp"

#include <gtest/gtest.h>

#include <future>
#include <optional>
#include <string>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/base/progress.hpp"
#include "names.hpp"
#include "nodes/trajectory_driver/drive_job.hpp"
#include "ros/drive/two_beads.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

using test::waitUntil;
using ActionGoal = follow::Action::_action_goal_type;

constexpr double kStartDelay = 0.5;  // s
constexpr double kPoint = 0.004;     // s between points
constexpr double kTolerance = 1e-6;  // s

class Uncancelled final : public Progress {
 public:
  void report(const std::string& /*stage*/, double /*fraction*/) override {}
  bool isCancelled() const override { return false; }
};

DriverSettings driverSettings() {
  DriverSettings settings;
  settings.machine.name = "five_axis_head_table";
  settings.is_clearance_checked = false;
  settings.start_delay_s = kStartDelay;
  settings.tracking.silence_s = 60.0;
  settings.controller_wait_s = 0.5;
  return settings;
}

/// A session whose clock, controller and machine are the test.
class SessionRun {
 public:
  SessionRun() {
    const boost::function<void(const boost::shared_ptr<const ActionGoal>&)> on_goal =
        [this](const auto& goal) { goals.push_back(goal->goal.trajectory); };
    const boost::function<void(const actionlib_msgs::GoalIDConstPtr&)> on_cancel =
        [this](const auto& cancel) { cancels.push_back(*cancel); };
    goals_ = node_.subscribe<ActionGoal>("follow_joint_trajectory/goal", 1000, on_goal);
    cancels_ = node_.subscribe<actionlib_msgs::GoalID>("follow_joint_trajectory/cancel", 1000, on_cancel);
    waitUntil([&] { return goals_.getNumPublishers() > 0 && cancels_.getNumPublishers() > 0; });
  }

  void pass(double time_s) {
    const std::lock_guard<std::mutex> lock(mutex_);
    now_.ros += ros::Duration(time_s);
    now_.steady_s = *now_.steady_s + time_s;
  }
  void setRosTimeOn(double time_s) {
    const std::lock_guard<std::mutex> lock(mutex_);
    now_.ros += ros::Duration(time_s);
  }
  ros::Time now() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return now_.ros;
  }
  /// Steps as the node does, for a time.
  void run(double time_s) {
    for (int step = 0; step < std::lround(time_s / 0.02); ++step) {
      pass(0.02);
      session.step();
    }
  }
  /// Goals come in the order in which they were sent, and before a cancel that was sent after them.
  bool isCancelled() {
    return waitUntil([&] { return !cancels.empty(); });
  }
  std::size_t goalsSoFar() {
    ros::spinOnce();
    return goals.size();
  }
  /// Joints report that they are where the last goal ends, but for the first one [m].
  void tellJoints(double off_m) {
    sensor_msgs::JointState state;
    state.name = goals.back().joint_names;
    state.position = goals.back().points.back().positions;
    state.position[0] += off_m;
    JointValues values(static_cast<Eigen::Index>(state.position.size()));
    for (std::size_t j = 0; j < state.position.size(); ++j)
      values[static_cast<Eigen::Index>(j)] =
          state.position[j] * (model_->joints()[j].kind == JointKind::Linear ? 1e3 : 1.0);
    ASSERT_TRUE(waitUntil([&] {
      told_.publish(state);
      try {
        return joints_.refusalAt(values, 0.0, 60.0, {}).empty();
      } catch (const TimedOut&) {  // before the first report
        return false;
      }
    }));
  }
  Failure failure() const { return session.status().failure; }

 private:
  DriveInstant look() {
    if (const auto wait = std::exchange(at_next_look, nullptr)) wait();
    if (look_s > 0.0) pass(look_s);
    const std::lock_guard<std::mutex> lock(mutex_);
    return now_;
  }
  static DriveJob jobOf(const KinematicModel& model, const DriverSettings& settings) {
    MachineToolpath placed;
    placed.machine = model.name();
    placed.toolpath = test::twoBeads();
    placed.id = toolpathId(placed.toolpath);
    Uncancelled progress;
    return driveJob(
        placed, model, settings, [](const MachineCheck&) {}, progress);
  }

  std::mutex mutex_;
  DriveInstant now_{ros::Time(1000.0), 10.0};
  ros::NodeHandle node_{"drive_session"};
  ros::Subscriber goals_, cancels_;
  const DriverSettings settings_ = driverSettings();
  const std::unique_ptr<const KinematicModel> model_ = kinematicModelOf(settings_.machine);
  const DriveJob job_ = jobOf(*model_, settings_);
  ControllerClient controller_{node_, *model_, [](const ControllerReport&) {}};
  ProcessPublisher process_{node_};
  PresentJoints joints_{node_, *model_};
  ros::Publisher told_ = node_.advertise<sensor_msgs::JointState>(names::kJointStates, 10);

 public:
  std::function<void()> at_next_look;  ///< of the session at its clock
  double look_s = 0.0;                 ///< that pass until each
  std::vector<trajectory_msgs::JointTrajectory> goals;
  std::vector<actionlib_msgs::GoalID> cancels;
  DriveSession session{{*job_.timed.trajectory, job_.placed.id},
                       *model_,
                       settings_,
                       {controller_, process_, joints_, [this] { return look(); }}};
};

TEST(DriveSession, GivesUpOnceRosTimeIsSetOn) {
  SessionRun run;
  run.session.step();
  run.run(1.0);
  run.setRosTimeOn(0.04);
  run.run(0.1);
  EXPECT_EQ(run.failure().code, ErrorCode::Ok) << "a clock may be corrected: " << run.failure().message;
  run.setRosTimeOn(0.3);
  run.run(0.02);
  EXPECT_EQ(run.failure().code, ErrorCode::DeviceError);
  EXPECT_NE(run.failure().message.find("ROS time was set on by 0.34 s"), std::string::npos)
      << run.failure().message;
  EXPECT_EQ(run.session.status().state, PackmlState::Aborted) << "with joints that are still";
  EXPECT_TRUE(run.isCancelled());
}

TEST(DriveSession, HandsOverNoPointsOfThePastOnceTheControllerRanDry) {
  SessionRun run;
  run.session.step();
  run.pass(3.0);
  run.session.step();
  EXPECT_EQ(run.failure().code, ErrorCode::DeviceError);
  EXPECT_NE(run.failure().message.find("nothing left to follow"), std::string::npos) << run.failure().message;
  EXPECT_EQ(run.session.status().feeding.starvations, 1U);
  ASSERT_TRUE(run.isCancelled());
  for (const trajectory_msgs::JointTrajectory& goal : run.goals)
    EXPECT_LT((goal.header.stamp - run.now()).toSec(), -2.0) << "sent at the first step";
}

/// The session is locked while it looks at its clock, as while it sends.
TEST(DriveSession, AbortsFromWhenItsTurnComes) {
  SessionRun run;
  run.session.step();
  run.run(1.5);
  const std::size_t before = run.goalsSoFar();
  std::promise<void> is_locked;
  std::promise<void> may_go_on;
  run.at_next_look = [&] {
    is_locked.set_value();
    may_go_on.get_future().wait();
  };
  std::thread stepping([&] { run.session.step(); });
  is_locked.get_future().wait();
  std::thread aborting([&] { run.session.abort({ErrorCode::Cancelled, "asked for"}); });
  ros::WallDuration(0.1).sleep();  // in which one that does not wait would have looked at the clock
  run.pass(0.3);
  may_go_on.set_value();
  stepping.join();
  aborting.join();
  run.session.leave({ErrorCode::Cancelled, "for good"});
  ASSERT_TRUE(run.isCancelled());
  ASSERT_GT(run.goals.size(), before);
  for (std::size_t i = before; i < run.goals.size(); ++i)
    EXPECT_GE((run.goals[i].header.stamp - run.now()).toSec(), -kPoint - kTolerance);
}

TEST(DriveSession, ChangesTheFeedFromWhenItIsWorkedOut) {
  SessionRun run;
  run.session.step();
  run.run(1.5);
  const double planned_s = run.session.status().duration_s;
  const std::size_t before = run.goalsSoFar();
  run.look_s = 0.1;
  EXPECT_TRUE(run.session.setShare(OverrideKind::Feed, 0.5));
  run.look_s = 0.0;
  const ros::Time sent = run.now();
  run.run(0.02);
  EXPECT_GT(run.session.status().duration_s, planned_s + 1.0);
  EXPECT_EQ(run.failure().code, ErrorCode::Ok) << run.failure().message;
  run.session.leave({ErrorCode::Cancelled, "for good"});
  ASSERT_TRUE(run.isCancelled());
  ASSERT_GT(run.goals.size(), before);
  for (std::size_t i = before; i < run.goals.size(); ++i)
    EXPECT_GE((run.goals[i].header.stamp - sent).toSec(), 0.0) << "what takes a place is not past";
}

TEST(DriveSession, ResumesOnlyWhereTheMachineStandsWhereItWasHeld) {
  SessionRun run;
  run.session.step();
  run.run(1.5);
  ASSERT_FALSE(run.session.pause());
  run.run(1.0);
  ASSERT_EQ(run.session.status().state, PackmlState::Held);
  run.goalsSoFar();
  run.tellJoints(0.01);
  const std::size_t before = run.goalsSoFar();
  const std::optional<std::string> refusal = run.session.resume();
  ASSERT_TRUE(refusal);
  const std::string joint = "joint '" + run.goals.back().joint_names[0] + "' is at ";
  EXPECT_NE(refusal->find(joint), std::string::npos) << *refusal;
  EXPECT_EQ(run.session.status().state, PackmlState::Held);
  EXPECT_EQ(run.goalsSoFar(), before);
  run.tellJoints(0.0005);
  EXPECT_EQ(run.session.resume().value_or(""), "") << "by half a millimetre a controller may be off";
  run.session.leave({ErrorCode::Cancelled, "for good"});
  ASSERT_TRUE(run.isCancelled());
  EXPECT_GT(run.goals.size(), before);
}

TEST(DriveSession, IsHeldThoughRosTimeIsSetOn) {
  SessionRun run;
  run.session.step();
  run.run(1.5);
  ASSERT_FALSE(run.session.pause());
  run.run(1.0);
  ASSERT_EQ(run.session.status().state, PackmlState::Held);
  run.setRosTimeOn(60.0);
  run.run(0.1);
  EXPECT_EQ(run.session.status().state, PackmlState::Held) << run.failure().message;
  EXPECT_EQ(run.failure().code, ErrorCode::Ok);
}

TEST(DriveSession, AnAbortBeforeTheFirstMotionMovesNothing) {
  SessionRun run;
  run.session.step();
  run.run(0.2);
  run.session.abort({ErrorCode::Cancelled, "asked for"});
  run.run(5.0);
  EXPECT_EQ(run.session.status().state, PackmlState::Aborted);
  run.goalsSoFar();
  const auto& start = run.goals.front().points.front().positions;
  for (const auto& point : run.goals.back().points) EXPECT_EQ(point.positions, start);
}

/// A goal that comes after the cancel is known by the time at which it was sent.
TEST(DriveSession, CancelsGoalsThatAreStillOnTheirWay) {
  SessionRun run;
  run.session.step();
  const ros::Time sent = ros::Time::now();
  run.session.leave({ErrorCode::Cancelled, "for good"});
  ASSERT_TRUE(waitUntil([&] { return run.cancels.size() == 2; }));
  EXPECT_TRUE(run.cancels[0].stamp.isZero()) << "all that have come";
  EXPECT_EQ(run.cancels[1].id, "");
  EXPECT_GE(run.cancels[1].stamp, sent);
}

}  // namespace
}  // namespace lamina
