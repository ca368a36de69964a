// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Layers at 45 deg in closed loop through all nodes, on a machine whose nozzle leans and whose sensor looks
// straight down.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/sensor_lean.hpp"
#include "lamina/planning/scan_pass.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "ros/loop/streamed_cell.hpp"

namespace lamina {
namespace {

using test::waitUntil;

constexpr double kLayer = 1.5;    // mm
constexpr double kWidth = 3.0;    // mm
constexpr double kLength = 24.0;  // mm: in one swath of the sensor
constexpr std::size_t kLayers = 14;
// As sliced: cut halfway up, a layer's contour begins on the bed, so that the first nozzle is 2.25 mm from
// it.
constexpr double kFirst = 0.5 * (kWidth - kLayer);

/// Where the layers begin: on the bed, at the foot of the wall.
Eigen::Isometry3d bedFromLayers() {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));
  pose.translation() = Point3(90, 110, 0);
  return pose;
}

/// A wall that stands upright on the bed: each bead lies as far behind the one below as it is high. In the
/// frame of the layers.
Toolpath uprightWall() {
  Toolpath wall;
  wall.part_name = "wall";
  for (std::size_t k = 0; k < kLayers; ++k) {
    const double z = kLayer * static_cast<double>(k + 1);
    const double y = kFirst + kLayer * static_cast<double>(k);
    Path bead;
    bead.role = PathRole::OuterWall;
    bead.bead = Bead{kWidth, kLayer};
    bead.feed_mm_s = 20.0;
    bead.points = {{0, y, z}, {kLength, y, z}};
    Path travel;
    travel.role = PathRole::Travel;
    travel.feed_mm_s = 100.0;
    if (k > 0) travel.points = {wall.layers.back().paths.back().lastPoint(), bead.points.front()};
    wall.layers.push_back({z, kLayer, {}});
    if (k > 0) wall.layers.back().paths.push_back(travel);
    wall.layers.back().paths.push_back(bead);
  }
  return wall;
}

MachineToolpath scannedWall() {
  const BuildSpace space = buildSpaceByName("gantry_45");
  const Eigen::Quaterniond inclined(bedFromLayers().linear());
  ScanSettings scan;
  scan.every_layers = 1;
  scan.feed_mm_s = 40.0;
  MachineToolpath placed;
  placed.machine = space.name;
  placed.toolpath = turned(
      withScanPasses(uprightWall(), scan, {sensorOffset(space, inclined), sensorLean(space, inclined)}),
      inclined);
  placed.bed_from_part = Eigen::Translation3d(bedFromLayers().translation());
  placed.id = toolpathId(placed.toolpath);
  return placed;
}

/// How the top of the wall is off its plan.
struct TopErrors {
  double rmse_mm = 0.0;
  double flatness_mm = 0.0;  ///< the same without its mean
};

/// A cell, and the top of the wall in it.
class LeaningCell : public test::StreamedCell {
 public:
  using StreamedCell::StreamedCell;

  /// Whether the surface that was published last has the last bead to its end.
  bool isTopThere() {
    return waitUntil([&] { return heightsOfTop().size() >= kLength - 1.0; });
  }

  TopErrors topErrors() const {
    const double planned = kLayer * static_cast<double>(kLayers);
    double sum = 0.0;
    double squares = 0.0;
    const std::map<int, std::vector<double>> heights = heightsOfTop();
    for (const auto& [place, all] : heights) {
      double mean = 0.0;
      for (const double height : all) mean += height / static_cast<double>(all.size());
      sum += mean - planned;
      squares += (mean - planned) * (mean - planned);
    }
    const auto count = static_cast<double>(heights.size());
    return {std::sqrt(squares / count), std::sqrt(squares / count - sum * sum / (count * count))};
  }

 private:
  /// Heights along the layers' normal on the last bead, by millimetre: from its middle to the end of its
  /// middle third, where the bead below does not reach.
  std::map<int, std::vector<double>> heightsOfTop() const {
    std::map<int, std::vector<double>> heights;
    const double middle = kFirst + kLayer * static_cast<double>(kLayers - 1);
    for (const Point3& point : surface(bedFromLayers().inverse()))
      if (point.y() > middle && point.y() < middle + kWidth / 6.0 && point.x() > 0.5 &&
          point.x() < kLength - 0.5)
        heights[static_cast<int>(point.x())].push_back(point.z());
    return heights;
  }
};

TEST(LeaningLoop, ComesNearerToThePlanAndFlatter) {
  LeaningCell open("open");
  LeaningCell closed("closed");
  const MachineToolpath wall = scannedWall();
  open.print(wall);
  closed.print(wall);
  for (LeaningCell* cell : {&open, &closed}) {
    ASSERT_TRUE(cell->hasEnded()) << cell->layers.size() << " layers";
    ASSERT_EQ(cell->status().code, lamina_msgs::Status::OK + 0) << cell->status().message;
    ASSERT_TRUE(cell->isTopThere());
  }
  for (const auto& layer : closed.layers) {
    EXPECT_TRUE(layer.is_measured) << layer.layer;
    EXPECT_GT(layer.coverage, 0.9) << layer.layer;
    EXPECT_GT(layer.repeatability, 0.5) << layer.layer << ": noise is as expected (6106)";
    EXPECT_LT(layer.repeatability, 2.0) << layer.layer;
    ROS_INFO("layer %u: mean %.3f mm, rmse %.3f mm, gain %.3f, noise %.2f", layer.layer,
             1e3 * layer.mean_error, 1e3 * layer.rmse, layer.gain_mean, layer.repeatability);
  }
  EXPECT_LT(1e3 * open.layers.front().mean_error, 0.35)
      << "a gain of 0.9 and soft ends, from where it is planned";
  const TopErrors without = open.topErrors();
  const TopErrors with = closed.topErrors();
  ROS_INFO("top of the wall: rmse %.3f mm open, %.3f mm closed; flatness %.3f mm open, %.3f mm closed",
           without.rmse_mm, with.rmse_mm, without.flatness_mm, with.flatness_mm);
  EXPECT_GT(without.rmse_mm, kLayers * kLayer * 0.1) << "a feeder that gives 0.9, and less at the ends";
  EXPECT_LT(with.rmse_mm, 0.4 * without.rmse_mm) << "closed at least 60 % below open";
  EXPECT_LT(with.flatness_mm, 0.4 * without.flatness_mm);
  EXPECT_NEAR(1e3 * closed.layers.back().rmse, with.rmse_mm, 0.1) << "what the loop says of its last layer";
}

}  // namespace
}  // namespace lamina
