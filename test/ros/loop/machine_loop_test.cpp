// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Emulated machines in closed loop through all of their nodes: pressed beads, and layers at 45 deg.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/angle.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "nodes/emulated_machine/machine_deposit.hpp"
#include "point_cloud.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

using test::kPatience;
using test::waitUntil;
using Client = actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction>;

constexpr double kLength = 60.0;       // mm: of walls, one bead a layer
constexpr double kSpeed = 10.0;        // mm/s
constexpr double kBesideMm = 25.0;     // along x, by which the sensor of these machines is beside the nozzle
const Point3 kPlace(100.0, 100.0, 0);  // of the walls on the bed

Path travelAlong(std::vector<Point3> points) {
  Path travel;
  travel.role = PathRole::Travel;
  travel.feed_mm_s = 40.0;
  travel.points = std::move(points);
  return travel;
}

Path beadAlong(const Point3& start, const Point3& end, const Bead& size) {
  Path bead;
  bead.role = PathRole::OuterWall;
  bead.bead = size;
  bead.feed_mm_s = kSpeed;
  bead.points = {start, end};
  return bead;
}

/// A wall along y, scanned along it.
Toolpath levelWall(std::size_t layers, const Bead& bead) {
  Toolpath wall;
  wall.part_name = "wall";
  for (std::size_t k = 0; k < layers; ++k) {
    const double z = bead.height_mm * static_cast<double>(k + 1);
    const double above = z + 4.0;
    const Point3 next(0, 0, k + 1 < layers ? z + bead.height_mm : above + 1.0);
    wall.layers.push_back(
        {z,
         bead.height_mm,
         {beadAlong({0, 0, z}, {0, kLength, z}, bead),
          travelAlong(
              {{0, kLength, z}, {-kBesideMm, kLength + 2.0, above}, {-kBesideMm, -2.0, above}, next})}});
  }
  return wall;
}

/// A wall along x in layers at 45 deg, scanned across it in two halves.
Toolpath leaningWall(std::size_t layers, const Bead& bead) {
  Toolpath wall;
  wall.part_name = "leaning wall";
  wall.part_from_layers = Eigen::Quaterniond(Eigen::AngleAxisd(45.0 * kDegree, Eigen::Vector3d::UnitX()));
  const auto at = [&](double x, double height) {
    return Point3(wall.part_from_layers * Point3(x, 0, height));
  };
  for (std::size_t k = 0; k < layers; ++k) {
    const double top = bead.height_mm * static_cast<double>(k + 1);
    const Point3 over = at(0.0, top) + Point3(0, 0, 4);
    const double left = 0.25 * kLength - kBesideMm;
    const double right = 0.75 * kLength - kBesideMm;
    const Point3 near(0, -4, 0);
    const Point3 far(0, 4, 0);
    const Point3 next = at(0.0, k + 1 < layers ? top + bead.height_mm : top + 6.0);
    wall.layers.push_back(
        {top,
         bead.height_mm,
         {beadAlong(at(0, top), at(kLength, top), bead),
          travelAlong({at(kLength, top), at(kLength, top + 5.0), over + Point3(right, 0, 0) + near,
                       over + Point3(right, 0, 0) + far, over + Point3(left, 0, 0) + far,
                       over + Point3(left, 0, 0) + near, at(0.0, top + 5.0), next})}});
  }
  return wall;
}

/// What was deposited, by places a quarter of a millimetre apart along a wall and across it: heights [mm].
using Heights = std::map<std::pair<int, int>, double>;

double placeOf(int index) { return 0.25 * (index + 0.5); }

/// @param along  axis of the wall's frame along which it goes
Heights heightsOf(const std::vector<Point3>& points, const Eigen::Isometry3d& wall_from_bed,
                  Eigen::Index along) {
  Heights heights;
  for (const Point3& each : points) {
    const Point3 at = wall_from_bed * each;
    const auto index = [](double mm) { return static_cast<int>(std::floor(mm / 0.25)); };
    const auto [known, is_new] = heights.try_emplace({index(at[along]), index(at[1 - along])}, at.z());
    if (!is_new) known->second = std::max(known->second, at.z());
  }
  return heights;
}

/// Root mean square of what the crown of the wall is off, without its last millimetre.
double rmseOf(const Heights& heights, double top_mm) {
  double squares = 0.0;
  double places = 0.0;
  for (const auto& [place, height] : heights) {
    const double along = placeOf(place.first);
    if (along < 1.0 || along > kLength - 1.0 || std::abs(placeOf(place.second)) > 0.5) continue;
    squares += (height - top_mm) * (height - top_mm);
    places += 1.0;
  }
  EXPECT_GT(places, 500.0) << "places of the crown";
  return std::sqrt(squares / places);
}

/// How far the contour of a bead as planned lies below its crown.
double plannedDepth(double across_mm, const Bead& bead) {
  const double round = 0.5 * bead.height_mm;
  const double beyond = std::clamp(std::abs(across_mm) - (0.5 * bead.width_mm - round), 0.0, round);
  return round - std::sqrt(round * round - beyond * beyond);
}

/// Share of the planned section that the last layer of a wall lacks beside its crown.
double openShareOf(const Heights& heights, const Bead& bead) {
  double open_mm3 = 0.0;
  const auto at = [&](int along, int across, double fallback) {
    const auto found = heights.find({along, across});
    return found == heights.end() ? fallback : found->second;
  };
  const int last = static_cast<int>(kLength / 0.25) - 20;
  for (int along = 20; along < last; ++along) {
    const double crown = at(along, 0, 0.0);
    for (int across = -12; across < 12; ++across) {
      const double depth = std::clamp(crown - at(along, across, 0.0), 0.0, bead.height_mm);
      open_mm3 += (depth - plannedDepth(placeOf(across), bead)) * 0.25 * 0.25;
    }
  }
  return open_mm3 / (crossSection(bead) * 0.25 * (last - 20));
}

/// What a machine lays that nobody corrects.
std::vector<Point3> laidOpen(const Toolpath& wall, const CartesianMachine& machine,
                             const EmulatedMachineSettings& settings) {
  const Eigen::Vector3d tool_axis =
      bedFromNozzle(machine, axisValues(machine, Point3::Zero())).linear().col(2);
  const auto deposit = bareBed(buildSpaceOf(machine), tool_axis.normalized(), settings);
  double now_s = 0.0;
  for (const ToolpathLayer& layer : wall.layers) {
    const Path& bead = layer.paths[0];
    const double volume = kLength * crossSection(bead.bead.at(1));
    deposit->lay({bead.points[0] + kPlace, bead.points[1] + kPlace, tool_axis, tool_axis, volume},
                 {now_s, now_s + kLength / kSpeed});
    deposit->endBead();
    now_s += kLength / kSpeed + length(layer.paths[1]) / 40.0;
  }
  return deposit->points();
}

/// A machine with its loop.
class LoopedMachine {
 public:
  explicit LoopedMachine(const std::string& space)
      : node_(space),
        toolpath_(node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true)),
        client_(node_, "stream_program", true) {
    const boost::function<void(const lamina_msgs::LoopFiguresConstPtr&)> on_layer =
        [this](const auto& message) {
          layers.push_back(*message);
          ROS_INFO("%s: layer %d, state %d, mean %.3f mm, rmse %.3f mm, coverage %.2f, gain %.3f",
                   node_.getNamespace().c_str(), int(message->layer), int(message->state),
                   1e3 * message->mean_error, 1e3 * message->rmse, message->coverage, message->gain_mean);
        };
    layers_ = node_.subscribe<lamina_msgs::LoopFigures>(names::kLoopFigures, 0, on_layer);
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_deposited =
        [this](const auto& message) { deposited_ = message; };
    deposits_ = node_.subscribe<sensor_msgs::PointCloud2>(names::kDeposited, 1, on_deposited);
  }

  void print(const Toolpath& wall, const std::string& machine) {
    MachineToolpath placed;
    placed.toolpath = wall;
    placed.machine = machine;
    placed.bed_from_part = Eigen::Translation3d(kPlace);
    placed.id = toolpathId(wall);
    EXPECT_TRUE(client_.waitForServer(ros::Duration(kPatience)));
    EXPECT_TRUE(
        waitUntil([&] { return toolpath_.getNumSubscribers() > 1 && layers_.getNumPublishers() > 0; }));
    publishLatched(toolpath_, toMessage(placed));
    lamina_msgs::StreamProgramGoal goal;
    goal.toolpath_id = placed.id;
    client_.sendGoal(goal);
  }
  bool isDone() const { return client_.getState().isDone(); }
  std::string outcome() const { return client_.getState().toString() + ": " + client_.getState().getText(); }

  /// What lies on the bed once all layers are done.
  std::vector<Point3> laid() {
    ros::WallDuration(2.0).sleep();  // the last cloud is at most a second late
    EXPECT_TRUE(waitUntil([&] { return deposited_ != nullptr; }));
    return fromMessage(*deposited_, Eigen::Isometry3d::Identity()).points;
  }

  std::vector<lamina_msgs::LoopFigures> layers;

 private:
  ros::NodeHandle node_;
  ros::Publisher toolpath_;
  Client client_;
  ros::Subscriber layers_, deposits_;
  sensor_msgs::PointCloud2ConstPtr deposited_;
};

TEST(MachineLoop, ComesNearerToThePlanThanWithoutIt) {
  const Bead wide{6.0, 2.0};
  const Bead narrow{3.0, 1.5};
  const Toolpath level = levelWall(12, wide);
  const Toolpath leaning = leaningWall(16, narrow);
  LoopedMachine pressed("pressed");
  LoopedMachine inclined("inclined");
  pressed.print(level, "cartesian_gantry");
  inclined.print(leaning, "gantry_45");
  for (int i = 0; i < 6 && !(pressed.isDone() && inclined.isDone()); ++i)
    waitUntil([&] { return pressed.isDone() && inclined.isDone(); });
  EXPECT_EQ(pressed.outcome().substr(0, 9), "SUCCEEDED") << pressed.outcome();
  EXPECT_EQ(inclined.outcome().substr(0, 9), "SUCCEEDED") << inclined.outcome();
  EXPECT_TRUE(waitUntil([&] { return pressed.layers.size() == 12 && inclined.layers.size() == 16; }));

  EmulatedMachineSettings settings;
  settings.deposit_cell_mm = 0.25;
  settings.plant.pressed = true;
  settings.plant.gain = 0.85;
  settings.plant.thermal = 0.1;
  settings.grown.bead_width_mm = 6.0;
  const Eigen::Isometry3d wall_from_bed(Eigen::Translation3d(-kPlace));
  const Heights open =
      heightsOf(laidOpen(level, machineByName("cartesian_gantry"), settings), wall_from_bed, 1);
  const Heights closed = heightsOf(pressed.laid(), wall_from_bed, 1);
  ROS_INFO("pressed: %.3f mm off open, %.3f mm closed; %.3f of the section lacking open, %.3f closed",
           rmseOf(open, 24.0), rmseOf(closed, 24.0), openShareOf(open, wide), openShareOf(closed, wide));
  EXPECT_GT(rmseOf(open, 24.0), 0.05);
  EXPECT_GT(openShareOf(open, wide), 0.1);
  EXPECT_LT(rmseOf(closed, 24.0), 0.4 * rmseOf(open, 24.0)) << "at least 60 % less";
  EXPECT_LT(openShareOf(closed, wide), 0.4 * openShareOf(open, wide));

  settings.plant = {};
  settings.plant.gain = 0.85;
  settings.plant.end_loss = 0.15;
  settings.plant.wave = 0.05;
  settings.plant.random = 0.03;
  settings.plant.levelling_mm = 1.0;
  settings.grown.bead_width_mm = 3.0;
  const Eigen::Isometry3d layers_from_bed(leaning.part_from_layers.inverse() * wall_from_bed);
  const double without =
      rmseOf(heightsOf(laidOpen(leaning, machineByName("gantry_45"), settings), layers_from_bed, 0), 24.0);
  const double with = rmseOf(heightsOf(inclined.laid(), layers_from_bed, 0), 24.0);
  ROS_INFO("inclined: %.3f mm off open, %.3f mm closed", without, with);
  EXPECT_GT(without, 1.0);
  EXPECT_LT(with, 0.4 * without) << "at least 60 % less";
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "machine_loop_test");
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
