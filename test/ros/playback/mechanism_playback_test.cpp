// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A toolpath with leaning tool axes played on every machine and robot: tip and tool axis of each waypoint are
// computed anew from tf alone, live and from a recording; and the nozzle's trajectory from that of the
// joints.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <cmath>
#include <memory>
#include <optional>

#include "conversions.hpp"
#include "joint_messages.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "ros/bag_player.hpp"
#include "ros/leaning_square.hpp"
#include "ros/node_process.hpp"
#include "ros/playback/tf_recording.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

bool isAt(const Eigen::Isometry3d& nozzle, const test::PlayedWaypoint& waypoint) {
  const Point3 tool_axis = nozzle.linear().col(2);
  const double turn =
      std::atan2(tool_axis.cross(waypoint.tool_axis).norm(), tool_axis.dot(waypoint.tool_axis));
  return (nozzle.translation() - waypoint.tip).norm() <= test::kSameTip && turn <= test::kSameToolAxis;
}

/// Slowing down, the tip is within its tolerance of the end before the tool axis is.
bool hasEnded(const test::PlayedSquare& played, const test::TfRecording& recording) {
  const auto nozzle = recording.lastNozzle();
  return nozzle && isAt(*nozzle, played.waypoints.back());
}

void expectPlayed(const test::PlayedSquare& played, const test::TfRecording& recording) {
  std::size_t reached = 0;
  for (const Eigen::Isometry3d& nozzle : recording.nozzles())
    while (reached < played.waypoints.size() && isAt(nozzle, played.waypoints[reached])) ++reached;
  EXPECT_EQ(reached, played.waypoints.size())
      << played.placed.machine << " never was at waypoint " << reached;
}

/// The joints and the nozzle of the layer that was announced last.
class PlannedLayer {
 public:
  explicit PlannedLayer(ros::NodeHandle& node) {
    const boost::function<void(const trajectory_msgs::JointTrajectoryConstPtr&)> on_joints =
        [this](const auto& message) { joints_ = *message; };
    const boost::function<void(const trajectory_msgs::MultiDOFJointTrajectoryConstPtr&)> on_nozzle =
        [this](const auto& message) { nozzle_ = *message; };
    joint_subscriber_ =
        node.subscribe<trajectory_msgs::JointTrajectory>(names::kJointTrajectory, 10, on_joints);
    nozzle_subscriber_ =
        node.subscribe<trajectory_msgs::MultiDOFJointTrajectory>(names::kCartesianTrajectory, 10, on_nozzle);
  }

  bool isComplete() const { return joints_ && nozzle_ && joints_->header.stamp == nozzle_->header.stamp; }

  /// Of the same rate, so that each point of the one is one of the other.
  void expectSameMotion(const KinematicModel& model) const {
    EXPECT_EQ(nozzle_->header.frame_id, "bed");
    ASSERT_EQ(nozzle_->points.size(), joints_->points.size());
    for (std::size_t i = 0; i < joints_->points.size(); ++i) {
      const auto& point = nozzle_->points[i];
      EXPECT_EQ(point.time_from_start, joints_->points[i].time_from_start);
      const JointState state = fromMessage(joints_->points[i], joints_->joint_names, model.joints());
      const Eigen::Isometry3d pose = model.bedFromNozzle(state.position);
      const auto& at = point.transforms[0].translation;
      EXPECT_LT((toMillimetres(1.0) * Point3(at.x, at.y, at.z) - pose.translation()).norm(), test::kSameTip)
          << i;
      EXPECT_LT(fromMessage(point.transforms[0].rotation).angularDistance(Eigen::Quaterniond(pose.linear())),
                test::kSameToolAxis)
          << i;
      if (state.velocity.norm() == 0.0) continue;
      // Where the joints are an instant later.
      const double h = 1e-6;
      const Eigen::Isometry3d next = model.bedFromNozzle(state.position + h * state.velocity);
      const auto& linear = point.velocities[0].linear;
      const Point3 moved = (next.translation() - pose.translation()) / h;
      EXPECT_LT((toMillimetres(1.0) * Point3(linear.x, linear.y, linear.z) - moved).norm(), 1e-2) << i;
    }
  }

 private:
  std::optional<trajectory_msgs::JointTrajectory> joints_;
  std::optional<trajectory_msgs::MultiDOFJointTrajectory> nozzle_;
  ros::Subscriber joint_subscriber_;
  ros::Subscriber nozzle_subscriber_;
};

class KinematicModelPlayback : public testing::TestWithParam<std::string> {};

TEST_P(KinematicModelPlayback, TfReportsEveryWaypointLiveAndFromARecording) {
  const std::string& name = GetParam();
  const auto model = kinematicModelByName(name);
  const test::PlayedSquare played = test::squareOn(*model);
  const test::TfRecording live(name);
  ros::NodeHandle node(name);
  const PlannedLayer layer(node);
  ros::Publisher toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  const test::NodeProcess publisher(
      LAMINA_PUBLISHER_NODE,
      {"__ns:=/" + name, "/tf:=/" + name + "/tf", "/tf_static:=/" + name + "/tf_static",
       "_machine/name:=" + name, "_speed_up:=5", "_cartesian/rate_hz:=50"});
  ASSERT_TRUE(test::waitUntil([&] { return live.isConnected(); }));
  publishLatched(toolpath, toMessage(played.placed));
  EXPECT_TRUE(test::waitUntil([&] { return hasEnded(played, live); }));
  expectPlayed(played, live);
  ASSERT_TRUE(test::waitUntil([&] { return layer.isComplete(); }));
  layer.expectSameMotion(*model);

  const test::ScratchFolder folder;
  rosbag::Bag bag(folder.file("played.bag"), rosbag::bagmode::Write);
  live.write(bag);
  bag.close();
  const test::TfRecording replayed("replayed/" + name);
  const test::BagPlayer player(folder.file("played.bag"), {"--delay=0.2", "--rate=10", "--prefix=/replayed"});
  EXPECT_TRUE(test::waitUntil([&] { return hasEnded(played, replayed); }));
  expectPlayed(played, replayed);
}

INSTANTIATE_TEST_SUITE_P(All, KinematicModelPlayback, testing::ValuesIn(kinematicModelNames()),
                         [](const auto& machine) { return machine.param; });

}  // namespace
}  // namespace lamina
