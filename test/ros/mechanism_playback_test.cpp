// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A toolpath with leaning tool axes played on every machine and robot: tip and tool axis of each waypoint are
// computed anew from tf alone, live and from a recording.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>

#include <cmath>
#include <memory>

#include "bag_player.hpp"
#include "conversions.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "latched.hpp"
#include "leaning_square.hpp"
#include "names.hpp"
#include "node_process.hpp"
#include "support/scratch_folder.hpp"
#include "tf_recording.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

constexpr double kSameTip = 1e-3;       // mm: 1e-6 m
constexpr double kSameToolAxis = 1e-6;  // rad

bool isAt(const Eigen::Isometry3d& nozzle, const test::PlayedWaypoint& waypoint) {
  const Point3 tool_axis = nozzle.linear().col(2);
  const double turn =
      std::atan2(tool_axis.cross(waypoint.tool_axis).norm(), tool_axis.dot(waypoint.tool_axis));
  return (nozzle.translation() - waypoint.tip).norm() <= kSameTip && turn <= kSameToolAxis;
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

class KinematicModelPlayback : public testing::TestWithParam<std::string> {};

TEST_P(KinematicModelPlayback, TfReportsEveryWaypointLiveAndFromARecording) {
  const std::string& name = GetParam();
  const auto model = kinematicModelByName(name);
  const test::PlayedSquare played = test::squareOn(*model);
  const test::TfRecording live(name);
  ros::NodeHandle node(name);
  ros::Publisher toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  const test::NodeProcess publisher(
      LAMINA_NODE, {"__ns:=/" + name, "/tf:=/" + name + "/tf", "/tf_static:=/" + name + "/tf_static",
                    "_machine/name:=" + name, "_speed_up:=5"});
  ASSERT_TRUE(test::waitUntil([&] { return live.isConnected(); }));
  publishLatched(toolpath, toMessage(played.placed));
  EXPECT_TRUE(test::waitUntil([&] { return hasEnded(played, live); }));
  expectPlayed(played, live);

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

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mechanism_playback_test");
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
