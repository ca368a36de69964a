// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot in closed loop through all of its nodes, on a process that grows otherwise than commanded.
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "lamina/control/replanned_toolpath.hpp"
#include "point_cloud.hpp"
#include "ros/drive/drive_cell.hpp"
#include "ros/loop/shown_cells.hpp"

namespace lamina {
namespace {

using test::DriveCell;
using test::waitUntil;

constexpr double kLayer = 1.5;      // mm
constexpr double kLength = 60.0;    // mm: walls go along y from 0
constexpr double kStandOff = 60.0;  // mm: of the sensor above the tip
constexpr std::size_t kLayers = 12;

/// One bead a layer, scanned on the way back to the start of the next.
Toolpath scannedWall() {
  Toolpath wall;
  wall.part_name = "wall";
  for (std::size_t k = 0; k < kLayers; ++k) {
    const double z = kLayer * static_cast<double>(k + 1);
    Path bead;
    bead.role = PathRole::OuterWall;
    bead.bead = Bead{3.0, kLayer};
    bead.feed_mm_s = 30.0;
    bead.points = {{0, 0, z}, {0, kLength, z}};
    Path scan;
    scan.role = PathRole::Travel;
    scan.feed_mm_s = 40.0;
    const double next = k + 1 < kLayers ? z + kLayer : z + 5.0;
    scan.points = {{0, kLength, z}, {0, kLength, z + 5.0}, {0, 0, z + 5.0}, {0, 0, next}};
    if (k + 1 == kLayers) scan.points.pop_back();
    wall.layers.push_back({z, kLayer, {bead, scan}});
  }
  return wall;
}

/// A cell with a sensor, and what the loop says of its layers.
class SensingCell : public DriveCell {
 public:
  explicit SensingCell(const std::string& space) : DriveCell(space, "irb_4600"), node_(space) {
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_profile =
        [this](const auto& message) { clouds_[message->header.stamp] = message; };
    const boost::function<void(const lamina_msgs::LoopFiguresConstPtr&)> on_layer =
        [this](const auto& message) { layers.push_back(*message); };
    profile_ = node_.subscribe<sensor_msgs::PointCloud2>(names::kProfile, 0, on_profile);
    const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> on_toolpath =
        [this](const auto& message) { driven.push_back(message->id); };
    toolpaths_ = node_.subscribe<lamina_msgs::Toolpath>(names::kToolpath, 10, on_toolpath);
    layers_ = node_.subscribe<lamina_msgs::LoopFigures>(names::kLoopFigures, 0, on_layer);
    const boost::function<void(const lamina_msgs::LoopStateConstPtr&)> on_state =
        [this](const auto& message) {
          note() << "loop " << message->state_name << ", " << message->alarm << ": " << message->reason;
        };
    states_ = node_.subscribe<lamina_msgs::LoopState>(names::kLoopState, 0, on_state);
    const boost::function<void(const lamina_msgs::AppliedCorrectionConstPtr&)> on_applied =
        [this](const auto& message) {
          note() << "driver, layer " << message->layer << " of " << message->toolpath_id << " by '"
                 << message->digest << "', waited " << message->waited << " s: " << message->reason;
        };
    applied_ = node_.subscribe<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 0, on_applied);
  }

  bool hasEnded() {
    for (int i = 0; i < 3 && !isDone(); ++i) ends();
    return isDone();
  }

  /// By how much the wall's top is higher than planned, as its last scan saw it from where the robot was: the
  /// median of each millimetre.
  std::vector<double> deviations() const {
    const double top = kLayer * static_cast<double>(kLayers);
    std::map<int, std::vector<double>> heights;
    for (std::size_t i = lastDeposit() + 1; i < reports.size(); ++i) {
      const auto cloud = clouds_.find(reports[i].process.header.stamp);
      if (cloud == clouds_.end()) continue;
      const Eigen::Isometry3d bed_from_sensor =
          model->bedFromNozzle(reports[i].joints) * Eigen::Translation3d(0, 0, -kStandOff);
      for (const Point3& point : fromMessage(*cloud->second, bed_from_sensor).points)
        if (std::abs(point.x()) < 0.5 && point.y() > 0.0 && point.y() < kLength)
          heights[static_cast<int>(point.y())].push_back(point.z());
    }
    EXPECT_GT(heights.size(), 50U) << "millimetres of the wall that were seen";
    std::vector<double> deviations;
    for (auto& [place, all] : heights) {
      std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
      deviations.push_back(all[all.size() / 2] - top);
    }
    return deviations;
  }
  double rmseOfTop() const {
    double squares = 0.0;
    const std::vector<double> all = deviations();
    for (const double each : all) squares += each * each / static_cast<double>(all.size());
    return std::sqrt(squares);
  }
  double meanOfTop() const {
    double sum = 0.0;
    const std::vector<double> all = deviations();
    for (const double each : all) sum += each / static_cast<double>(all.size());
    return sum;
  }

  /// What loop and driver said, in the order of arrival, and what the layers came to.
  std::string history() const {
    std::ostringstream report;
    report << notes_.str();
    for (const lamina_msgs::LoopFigures& layer : layers) {
      report << "\nlayer " << layer.layer << " of " << layer.toolpath_id << ": state " << int{layer.state}
             << ", mean " << 1e3 * layer.mean_error << " mm, rmse " << 1e3 * layer.rmse << " mm, coverage "
             << layer.coverage << ", contested " << layer.contested_share << ", limited "
             << layer.limited_share << ", gain " << layer.gain_mean << ", alarms";
      for (const auto alarm : layer.alarms) report << ' ' << alarm;
    }
    return report.str();
  }

  std::vector<lamina_msgs::LoopFigures> layers;
  std::vector<std::string> driven;  ///< toolpaths, of plans too

 private:
  std::ostream& note() { return notes_ << '\n' << ros::Time::now() << ' '; }

  ros::NodeHandle node_;
  std::ostringstream notes_;
  std::map<ros::Time, sensor_msgs::PointCloud2ConstPtr> clouds_;
  ros::Subscriber profile_, layers_, toolpaths_, states_, applied_;
};

TEST(RobotLoop, ComesNearerToThePlanThanWithoutIt) {
  SensingCell open("open");
  SensingCell closed("closed");
  open.drive(scannedWall());
  closed.drive(scannedWall());
  for (SensingCell* cell : {&open, &closed}) {
    ASSERT_TRUE(cell->hasEnded());
    ASSERT_EQ(cell->result().status.code, lamina_msgs::Status::OK + 0) << cell->result().status.message;
    EXPECT_TRUE(waitUntil([&] { return cell->layers.size() == kLayers; })) << cell->layers.size();
    EXPECT_TRUE(cell->staysSafe());
  }
  const double without_mm = open.rmseOfTop();
  const double with_mm = closed.rmseOfTop();
  RecordProperty("rmse_open_um", static_cast<int>(1e3 * without_mm));
  RecordProperty("rmse_closed_um", static_cast<int>(1e3 * with_mm));
  ROS_INFO("top of the wall: %.3f mm off open, %.3f mm closed", without_mm, with_mm);
  EXPECT_GT(without_mm, 12 * kLayer * 0.1) << "a feeder that gives 0.9, and less at the ends";
  EXPECT_LT(with_mm, 0.4 * without_mm) << "closed at least 60 % below open";
  EXPECT_NEAR(1e3 * closed.layers.back().rmse, with_mm, 0.1) << "what the loop says of its last layer";
  for (const auto& layer : closed.layers) EXPECT_TRUE(layer.is_measured) << layer.layer;
}

/// A feeder that brings little more than half, which amounts alone cannot make up for.
TEST(RobotLoop, GoesOnWithTheLayersLeftPlannedAnew) {
  SensingCell cell("replanned");
  const test::ShownCells shown(ros::NodeHandle("replanned"));
  cell.drive(scannedWall());
  ASSERT_TRUE(cell.hasEnded());
  ASSERT_EQ(cell.result().status.code, lamina_msgs::Status::OK + 0)
      << cell.result().status.message << cell.history();
  ASSERT_TRUE(waitUntil([&] { return cell.driven.size() > 1; })) << "no plan" << cell.history();
  for (std::size_t i = 1; i < cell.driven.size(); ++i)
    EXPECT_TRUE(isPlanOf(cell.driven[i], cell.driven[i - 1])) << cell.driven[i];
  EXPECT_TRUE(cell.staysSafe());
  const double off_mm = cell.meanOfTop();
  ROS_INFO("top of the wall: %.3f mm off, planned anew %zu times", off_mm, cell.driven.size() - 1);
  EXPECT_LT(std::abs(off_mm), 0.5 * kLayer) << cell.history();
  EXPECT_TRUE(waitUntil([&] { return shown.areAll(cell.layers.size()); }))
      << "beads of each layer, also of plans";
  // The plan that the driver published took no toolpath's place.
  cell.ask(toolpathId(scannedWall()));
  EXPECT_TRUE(waitUntil([&] { return cell.state == "Execute" || cell.isDone(); }));
  EXPECT_TRUE(cell.calls("abort"));
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, lamina_msgs::Status::CANCELLED + 0) << cell.result().status.message;
}

}  // namespace
}  // namespace lamina
