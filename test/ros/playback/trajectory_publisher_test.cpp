// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "conversions.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "ros/node_process.hpp"
#include "ros/test_clock.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

const Point3 kPartOnBed(100.0, 50.0, 0.0);
constexpr double kRate = 20.0;            // Hz, of the player
constexpr double kCartesianRate = 200.0;  // Hz

/// A square wall of 10 mm on two layers, placed on the bed.
MachineToolpath square() {
  MachineToolpath placed;
  placed.id = "0123456789abcdef";
  placed.machine = "cartesian_gantry";
  placed.bed_from_part = Eigen::Translation3d(kPartOnBed);
  placed.toolpath.part_name = "square";
  for (const double z : {0.2, 0.4}) {
    Path wall;
    wall.role = PathRole::OuterWall;
    wall.is_closed = true;
    wall.points = {{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}};
    wall.bead = Bead{0.4, 0.2};
    wall.feed_mm_s = 50.0;
    Path climb;
    climb.role = PathRole::Travel;
    climb.points = {{0, 0, z - 0.2}, {0, 0, z}};
    climb.feed_mm_s = 50.0;
    placed.toolpath.layers.push_back({z, 0.2, {climb, wall}});
  }
  return placed;
}

template <class Message>
using Callback = boost::function<void(const boost::shared_ptr<const Message>&)>;

/// Everything one of the two nodes publishes.
class Listener {
 public:
  explicit Listener(const std::string& name) : node_(name), buffer_(ros::Duration(3600.0)) {
    const Callback<tf2_msgs::TFMessage> on_tf = [this](const auto& message) { keep(*message, false); };
    const Callback<tf2_msgs::TFMessage> on_tf_static = [this](const auto& message) { keep(*message, true); };
    const Callback<nav_msgs::Path> on_path = [this](const auto& message) { path = *message; };
    const Callback<trajectory_msgs::JointTrajectory> on_trajectory = [this](const auto& message) {
      trajectories.push_back(*message);
    };
    const Callback<sensor_msgs::JointState> on_state = [this](const auto& message) {
      states.push_back(message->header.stamp);
      positions.push_back(*message);
    };
    tf_ = node_.subscribe<tf2_msgs::TFMessage>("tf", 10000, on_tf);
    tf_static_ = node_.subscribe<tf2_msgs::TFMessage>("tf_static", 100, on_tf_static);
    path_ = node_.subscribe<nav_msgs::Path>(names::kNozzlePath, 10, on_path);
    trajectory_ =
        node_.subscribe<trajectory_msgs::JointTrajectory>(names::kJointTrajectory, 10, on_trajectory);
    states_ = node_.subscribe<sensor_msgs::JointState>(names::kJointStates, 10000, on_state);
    const Callback<trajectory_msgs::MultiDOFJointTrajectory> on_nozzle = [this](const auto& message) {
      nozzles.push_back(*message);
    };
    const Callback<lamina_msgs::ProcessTrajectory> on_process = [this](const auto& message) {
      processes.push_back(*message);
    };
    nozzle_ =
        node_.subscribe<trajectory_msgs::MultiDOFJointTrajectory>(names::kCartesianTrajectory, 10, on_nozzle);
    process_ = node_.subscribe<lamina_msgs::ProcessTrajectory>(names::kCartesianProcess, 10, on_process);
    toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 10, true);
    position_ = node_.advertise<sensor_msgs::JointState>(names::kMachinePosition, 10000);
  }

  void send(const lamina_msgs::Toolpath& message) { publishLatched(toolpath_, message); }
  void report(const Point3& axes_mm, const ros::Time& stamp) {
    sensor_msgs::JointState state;
    state.header.stamp = stamp;
    state.name = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) state.position.push_back(toMetres(axes_mm[i]));
    position_.publish(state);
  }
  bool isConnected() const {
    return toolpath_.getNumSubscribers() > 0 && tf_.getNumPublishers() > 0 && path_.getNumPublishers() > 0;
  }
  bool isFollowed() const { return position_.getNumSubscribers() > 0; }
  bool canTransform(const std::string& target, const std::string& source, const ros::Time& stamp) const {
    return buffer_.canTransform(target, source, stamp);
  }
  Eigen::Isometry3d transform(const std::string& target, const std::string& source,
                              const ros::Time& stamp) const {
    const auto found = buffer_.lookupTransform(target, source, stamp).transform;
    geometry_msgs::Pose pose;
    pose.position.x = found.translation.x;
    pose.position.y = found.translation.y;
    pose.position.z = found.translation.z;
    pose.orientation = found.rotation;
    return fromMessage(pose);
  }
  ros::NodeHandle& node() { return node_; }

  nav_msgs::Path path;
  std::vector<trajectory_msgs::JointTrajectory> trajectories;
  std::vector<trajectory_msgs::MultiDOFJointTrajectory> nozzles;
  std::vector<lamina_msgs::ProcessTrajectory> processes;
  std::vector<ros::Time> states;  ///< stamps
  std::vector<sensor_msgs::JointState> positions;

 private:
  void keep(const tf2_msgs::TFMessage& message, bool is_static) {
    for (const auto& transform : message.transforms) buffer_.setTransform(transform, "test", is_static);
  }

  ros::NodeHandle node_;
  tf2::BufferCore buffer_;
  ros::Subscriber tf_, tf_static_, path_, trajectory_, states_, nozzle_, process_;
  ros::Publisher toolpath_, position_;
};

bool await(const std::function<bool()>& isTrue) { return test::waitUntil(isTrue); }

TEST(TrajectoryPublisher, FollowsTheMachineAtItsOwnStamps) {
  Listener listener("follower");
  ASSERT_TRUE(await([&] { return listener.isConnected() && listener.isFollowed(); }));
  const MachineToolpath placed = square();
  listener.send(toMessage(placed));
  ASSERT_TRUE(await([&] { return listener.canTransform("world", "part", ros::Time(0)); }));
  // A machine in accelerated time reports faster than the clock runs.
  const auto& points = placed.toolpath.layers[0].paths[1].points;
  const auto stamp = [](int i) { return ros::Time(1000.0 + 0.01 * i); };
  for (int i = 0; i < 2000; ++i)
    listener.report(kPartOnBed + points[static_cast<std::size_t>(i) % 4], stamp(i));
  ASSERT_TRUE(await([&] { return listener.canTransform("part", "nozzle", stamp(1999)); }));
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Isometry3d part_from_nozzle = listener.transform("part", "nozzle", stamp(i));
    EXPECT_TRUE(part_from_nozzle.translation().isApprox(points[static_cast<std::size_t>(i) % 4], 1e-6)) << i;
    EXPECT_TRUE(part_from_nozzle.linear().isApprox(nozzleDown().toRotationMatrix(), 1e-6));
  }
  EXPECT_TRUE(listener.canTransform("world", "sensor", stamp(1999)));
}

TEST(TrajectoryPublisher, ReportsToLateSubscribersWhereTheMachineRests) {
  Listener listener("follower");
  ASSERT_TRUE(await([&] { return listener.isConnected() && listener.isFollowed(); }));
  const ros::Time rest(2000.0);
  listener.report(Point3(30.0, 40.0, 5.0), rest);
  ASSERT_TRUE(await([&] { return listener.canTransform("bed", "nozzle", rest); }));
  const Listener late("follower");
  ASSERT_TRUE(await([&] { return late.canTransform("bed", "nozzle", rest); }));
  EXPECT_TRUE(late.transform("bed", "nozzle", rest).translation().isApprox(Point3(30.0, 40.0, 5.0), 1e-6));
}

/// tf takes one transform at a time: by stamps of 0 the machine would never be seen to move.
TEST(TrajectoryPublisher, PassesOnNoPositionWithoutAStamp) {
  Listener listener("follower");
  ASSERT_TRUE(await([&] { return listener.isConnected() && listener.isFollowed(); }));
  listener.report(Point3(10.0, 10.0, 5.0), ros::Time());
  const ros::Time after(3000.0);
  listener.report(Point3(30.0, 40.0, 5.0), after);
  ASSERT_TRUE(await([&] { return std::count(listener.states.begin(), listener.states.end(), after) > 0; }));
  EXPECT_EQ(std::count(listener.states.begin(), listener.states.end(), ros::Time()), 0);
}

TEST(TrajectoryPublisher, ThinsOutThePathOfTheNozzleToItsSpacing) {
  Listener listener("follower");
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  listener.send(toMessage(square()));
  // At 12 mm of each layer's square of 10 mm its start, the opposite corner and its end.
  ASSERT_TRUE(await([&] { return listener.path.poses.size() == 6U; })) << listener.path.poses.size();
  for (const std::size_t layer : {0U, 1U})
    for (const std::size_t i : {0U, 1U, 2U}) {
      const geometry_msgs::Point& at = listener.path.poses[3 * layer + i].pose.position;
      EXPECT_NEAR(at.x, i == 1 ? 0.01 : 0.0, 1e-12);
      EXPECT_NEAR(at.y, i == 1 ? 0.01 : 0.0, 1e-12);
    }
}

TEST(TrajectoryPublisher, PlaysTheToolpathToItsEnd) {
  Listener listener("player");
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  const MachineToolpath placed = square();
  listener.send(toMessage(placed));
  const Point3 last = placed.toolpath.layers.back().paths.back().lastPoint();
  const auto isAtEnd = [&] {
    return listener.canTransform("part", "nozzle", ros::Time(0)) &&
           (listener.transform("part", "nozzle", ros::Time(0)).translation() - last).norm() < 1e-6;
  };
  EXPECT_TRUE(await(isAtEnd));
  // Start and four corners of each layer; the climb is shorter than the spacing.
  EXPECT_TRUE(await([&] { return listener.path.poses.size() == 10U; })) << listener.path.poses.size();
  const auto rises = [](const std::vector<double>& positions) {
    return std::abs(positions[2] - 0.0004) < 1e-9;
  };
  // Topics arrive each on its own connection: neither is behind the path for certain.
  ASSERT_TRUE(await([&] {
    return !listener.trajectories.empty() && rises(listener.trajectories.back().points.back().positions);
  }));
  const auto& end = listener.trajectories.back().points.back().positions;
  ASSERT_TRUE(await([&] {
    return !listener.positions.empty() && rises(listener.positions.back().position) &&
           std::abs(listener.positions.back().position[0] - end[0]) < 1e-6 &&
           std::abs(listener.positions.back().position[1] - end[1]) < 1e-6;
  }));
  const auto& planned = listener.trajectories.back().points;
  // Stamps of the layer's corners are as far apart as they are passed, however late a tick is.
  std::vector<ros::Time> passed;
  for (const auto& state : listener.positions)
    if (std::abs(state.position[2] - end[2]) < 1e-9 &&
        std::hypot(state.position[0] - end[0], state.position[1] - end[1]) > 1e-6)
      passed.push_back(state.header.stamp);
  ASSERT_GE(passed.size(), 3U);
  EXPECT_LT(passed.back() - passed.front(), planned.back().time_from_start * 0.1) << "speed_up";
  for (std::size_t i = 1; i + 1 < planned.size(); ++i)
    EXPECT_NEAR((planned[i].time_from_start - planned[i - 1].time_from_start).toSec(), 1.0 / kRate, 1e-6);
}

Point3 inMillimetres(const geometry_msgs::Vector3& vector) {
  return toMillimetres(1.0) * Point3(vector.x, vector.y, vector.z);
}

TEST(TrajectoryPublisher, PublishesTheNozzleOverTheBedAsTheAxesMove) {
  Listener listener("player");
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  MachineToolpath placed = square();
  placed.id = "fedcba9876543210";
  listener.send(toMessage(placed));
  const auto hasBoth = [&] {
    return !listener.processes.empty() && listener.processes.back().toolpath_id == placed.id &&
           !listener.trajectories.empty() && !listener.nozzles.empty() &&
           listener.nozzles.back().header.stamp == listener.processes.back().header.stamp &&
           listener.trajectories.back().header.stamp == listener.processes.back().header.stamp;
  };
  ASSERT_TRUE(await(hasBoth));
  const auto& nozzle = listener.nozzles.back();
  const auto& axes = listener.trajectories.back();
  EXPECT_EQ(nozzle.header.frame_id, "bed");
  EXPECT_EQ(nozzle.joint_names, (std::vector<std::string>{"nozzle"}));
  ASSERT_EQ(listener.processes.back().points.size(), nozzle.points.size());
  std::size_t cruising = 0;
  for (std::size_t i = 0; i < nozzle.points.size(); ++i) {
    const auto& point = nozzle.points[i];
    if (i + 1 < nozzle.points.size()) {
      EXPECT_NEAR(point.time_from_start.toSec(), static_cast<double>(i) / kCartesianRate, 1e-6);
    }
    const Point3 velocity = inMillimetres(point.velocities[0].linear);
    EXPECT_EQ(inMillimetres(point.velocities[0].angular).norm(), 0.0);
    EXPECT_LE(velocity.norm(), 50.0 + 1e-6);
    // The bead of 0.4 x 0.2 mm, at the speed of the tip.
    const double flow = toCubicMillimetres(listener.processes.back().points[i].flow);
    const bool is_deposited = velocity.head<2>().norm() > 0.0;
    EXPECT_NEAR(flow, is_deposited ? velocity.norm() * crossSection({0.4, 0.2}) : 0.0, 1e-6) << i;
    if (velocity.head<2>().norm() > 50.0 - 1e-6) ++cruising;
  }
  // At 1500 mm/s² each side of 10 mm is 8.3 mm or more at 50 mm/s: 33 of 200 states a second.
  EXPECT_GE(cruising, 4U * 30U);
  const std::size_t every = static_cast<std::size_t>(kCartesianRate / kRate);
  for (std::size_t i = 0; i + 1 < axes.points.size(); ++i) {
    ASSERT_LT(every * i, nozzle.points.size());
    const auto& at = nozzle.points[every * i].transforms[0].translation;
    const auto& positions = axes.points[i].positions;
    EXPECT_LT((Point3(at.x, at.y, at.z) - Point3(positions[0], positions[1], positions[2])).norm(), 1e-9);
  }
}

TEST(TrajectoryPublisher, PublishesPositionsAtItsRate) {
  Listener listener("player");
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  listener.send(toMessage(square()));
  std_srvs::Trigger pause;  // so that waypoints add none
  ASSERT_TRUE(
      listener.node().serviceClient<std_srvs::Trigger>("trajectory_publisher/pause", true).call(pause));
  listener.states.clear();
  constexpr std::size_t kPeriods = 20;
  ASSERT_TRUE(await([&] { return listener.states.size() > kPeriods + 1; }));
  // A tick that is late does not bring the next one forward by more than its lateness.
  const auto& states = listener.states;
  EXPECT_GE((states[kPeriods + 1] - states[1]).toSec(), (kPeriods - 1) / kRate);
  std_srvs::Trigger play;
  EXPECT_TRUE(listener.node().serviceClient<std_srvs::Trigger>("trajectory_publisher/play", true).call(play));
}

TEST(TrajectoryPublisher, PlaysOnWhenRosTimeGoesBack) {
  test::TestClock clock("/clocked");
  Listener listener("clocked");
  const test::NodeProcess player(
      LAMINA_PUBLISHER_NODE,
      clock.followedBy({"/tf:=/clocked/tf", "/tf_static:=/clocked/tf_static", "_speed_up:=50"}));
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  listener.send(toMessage(square()));
  ASSERT_TRUE(await([&] { return !listener.states.empty(); }));
  const ros::Time before = listener.states.back();
  clock.goBack(500.0);
  EXPECT_TRUE(await([&] { return listener.states.back() < before - ros::Duration(400.0); }))
      << "the last is of " << listener.states.back();
}

TEST(TrajectoryPublisher, PausesRewindsAndPlaysOnRequest) {
  Listener listener("player");
  std_srvs::Trigger trigger;
  const auto call = [&](const std::string& name) {
    return listener.node()
        .serviceClient<std_srvs::Trigger>("trajectory_publisher/" + name, true)
        .call(trigger);
  };
  ASSERT_TRUE(
      ros::service::waitForService("/player/trajectory_publisher/pause", ros::Duration(test::kPatience)));
  listener.send(toMessage(square()));
  EXPECT_TRUE(call("pause") && call("rewind"));
  EXPECT_TRUE(await([&] {
    return listener.canTransform("part", "nozzle", ros::Time(0)) &&
           listener.transform("part", "nozzle", ros::Time(0)).translation().norm() < 1e-6;
  }));
  EXPECT_TRUE(call("play"));
}

TEST(TrajectoryPublisher, SurvivesToolpathsItCannotUse) {
  Listener listener("player");
  ASSERT_TRUE(await([&] { return listener.isConnected(); }));
  lamina_msgs::Toolpath broken = toMessage(square());
  broken.layers[0].paths[0].points[0].x = std::nan("");
  listener.send(broken);
  MachineToolpath far = square();
  far.bed_from_part = Eigen::Translation3d(1000.0, 0.0, 0.0);
  listener.send(toMessage(far));
  MachineToolpath foreign = square();
  foreign.machine = "gantry_45";
  listener.send(toMessage(foreign));
  listener.path = nav_msgs::Path();
  listener.send(toMessage(square()));
  EXPECT_TRUE(await([&] { return listener.path.poses.size() == 10U; }));
}

TEST(TrajectoryPublisher, EndsWithCode1OnAnUnknownMachine) {
  const std::string command =
      std::string(LAMINA_PUBLISHER_NODE) + " __name:=refused _machine/name:=delta > /dev/null 2>&1";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(TrajectoryPublisher, DescribesTheMachineForRviz) {
  std::string description;
  EXPECT_TRUE(ros::param::get("/player/robot_description", description));
  EXPECT_NE(description.find("<robot name=\"cartesian_gantry\">"), std::string::npos);
}

}  // namespace
}  // namespace lamina
