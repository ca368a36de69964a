// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A toolpath with leaning jets played on every machine and robot: tip and jet of each waypoint are computed
// anew from tf alone, live and from a recording.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "conversions.hpp"
#include "lamina/kinematics/mechanism.hpp"
#include "names.hpp"
#include "node_process.hpp"
#include "support/scratch_folder.hpp"
#include "tf_recording.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

constexpr double kSameTip = 1e-3;  // mm: 1e-6 m
constexpr double kSameJet = 1e-6;  // rad
constexpr double kLean = 0.15;     // rad
constexpr double kEndless = 1e5;   // mm, rad

struct Waypoint {
  Point3 tip;  ///< [mm, bed frame]
  Point3 jet;
};

struct Case {
  MachineToolpath placed;
  std::vector<Waypoint> waypoints;  ///< in the order of the motion
};

/// Off the middle of all joints, where no wrist is straight and no jet upright.
JointValues offTheMiddle(const Mechanism& mechanism) {
  JointValues values(static_cast<Eigen::Index>(mechanism.joints().size()));
  for (std::size_t j = 0; j < mechanism.joints().size(); ++j) {
    const DrivenJoint& joint = mechanism.joints()[j];
    const bool is_endless = joint.high - joint.low > kEndless;
    values[static_cast<Eigen::Index>(j)] = is_endless ? 100.0 : joint.low + 0.6 * (joint.high - joint.low);
  }
  return values;
}

bool canTilt(const Mechanism& mechanism) {
  std::size_t rotary = 0;
  for (const DrivenJoint& joint : mechanism.joints()) rotary += joint.kind == JointKind::Rotary ? 1 : 0;
  return rotary >= 2;
}

/// A square on two layers about where the nozzle is with its joints off the middle, the jet leaning in turn.
Case squareOn(const Mechanism& mechanism) {
  const Eigen::Isometry3d nozzle = mechanism.bedFromNozzle(offTheMiddle(mechanism));
  Case made;
  made.placed.machine = mechanism.name();
  made.placed.bed_from_part = Eigen::Translation3d(nozzle.translation());
  made.placed.toolpath.part_name = "square";
  Eigen::Quaterniond upright(nozzle.linear());
  for (const double z : {0.0, 0.5}) {
    Path travel;
    travel.role = PathRole::Travel;
    travel.points = {{0, 0, z - 0.5}, {0, 0, z}};
    Path wall;
    wall.role = PathRole::OuterWall;
    wall.is_closed = true;
    wall.points = {{0, 0, z}, {8, 0, z}, {8, 6, z}, {0, 6, z}};
    // Ends where it has not been before.
    if (z > 0.0)
      wall.points = {{0, 0, z}, {8, 0, z}, {8, 6, z}, {0, 6, z}, {-2, 6, z}}, wall.is_closed = false;
    wall.bead = Bead{0.8, 0.5};
    for (Path* path : {&travel, &wall}) {
      path->feed_mm_s = 40.0;
      std::vector<Eigen::Quaterniond> held;
      for (std::size_t i = 0; i < path->points.size(); ++i) {
        const double lean = canTilt(mechanism) && path == &wall ? (i % 2 == 0 ? 0.0 : kLean) : 0.0;
        held.emplace_back(upright * Eigen::AngleAxisd(lean, Point3(1, 1, 0).normalized()));
      }
      path->orientation = AlongPath<Eigen::Quaterniond>(held);
      for (std::size_t i = 0; i <= path->motionCount(); ++i) {
        const std::size_t at = i % path->points.size();
        made.waypoints.push_back({made.placed.bed_from_part * path->points[at], held[at] * Point3::UnitZ()});
      }
    }
    made.placed.toolpath.layers.push_back({z, 0.5, {travel, wall}});
  }
  made.placed.id = toolpathId(made.placed.toolpath);
  return made;
}

bool isAt(const Eigen::Isometry3d& nozzle, const Waypoint& waypoint) {
  const Point3 jet = nozzle.linear().col(2);
  const double turn = std::atan2(jet.cross(waypoint.jet).norm(), jet.dot(waypoint.jet));
  return (nozzle.translation() - waypoint.tip).norm() <= kSameTip && turn <= kSameJet;
}

/// Slowing down, the tip is within its tolerance of the end before the jet is.
bool hasEnded(const Case& played, const test::TfRecording& recording) {
  const auto nozzle = recording.lastNozzle();
  return nozzle && isAt(*nozzle, played.waypoints.back());
}

void expectPlayed(const Case& played, const test::TfRecording& recording) {
  std::size_t reached = 0;
  for (const Eigen::Isometry3d& nozzle : recording.nozzles())
    while (reached < played.waypoints.size() && isAt(nozzle, played.waypoints[reached])) ++reached;
  EXPECT_EQ(reached, played.waypoints.size())
      << played.placed.machine << " never was at waypoint " << reached;
}

class MechanismPlayback : public testing::TestWithParam<std::string> {};

TEST_P(MechanismPlayback, TfTellsEveryWaypointLiveAndFromARecording) {
  const std::string& name = GetParam();
  const auto mechanism = mechanismByName(name);
  const Case played = squareOn(*mechanism);
  const test::TfRecording live(name);
  ros::NodeHandle node(name);
  ros::Publisher toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  const test::NodeProcess publisher(
      LAMINA_NODE, {"__ns:=/" + name, "/tf:=/" + name + "/tf", "/tf_static:=/" + name + "/tf_static",
                    "_machine/name:=" + name, "_speed_up:=5"});
  ASSERT_TRUE(test::waitUntil([&] { return live.isConnected(); }));
  toolpath.publish(toMessage(played.placed));
  EXPECT_TRUE(test::waitUntil([&] { return hasEnded(played, live); }));
  expectPlayed(played, live);

  const test::ScratchFolder folder;
  rosbag::Bag bag(folder.file("played.bag"), rosbag::bagmode::Write);
  live.write(bag);
  bag.close();
  const test::TfRecording replayed("replayed/" + name);
  const std::string play =
      "rosrun rosbag play --quiet --delay=0.2 --rate=10 --wait-for-subscribers --prefix=/replayed ";
  ASSERT_EQ(std::system((play + folder.file("played.bag")).c_str()), 0);
  EXPECT_TRUE(test::waitUntil([&] { return hasEnded(played, replayed); }));
  expectPlayed(played, replayed);
}

INSTANTIATE_TEST_SUITE_P(All, MechanismPlayback, testing::ValuesIn(mechanismNames()),
                         [](const auto& machine) { return machine.param; });

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mechanism_playback_test");
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
