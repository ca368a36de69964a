// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The layer_height_monitor in the namespace `inclined`: layers at 45 degrees on a belt that carries the bed
// along.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

constexpr double kOffsets[] = {0.031, -0.017};  // mm by which the plates are too high
constexpr double kBelt = 10.0;                  // mm/s, along -y
constexpr char kFurther[] = "left";             // frame of a further sensor
constexpr double kLate = 0.05;                  // s, by which its stamps are: 2.5 mm of the scan

template <class Message>
using Hears = boost::function<void(const boost::shared_ptr<const Message>&)>;

Eigen::Isometry3d bedFromLayers() {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));
  pose.translation() = Point3(50, 40, 7);
  return pose;
}

lamina_msgs::Toolpath inclinedPlates() {
  const test::PlateScan scan;
  MachineToolpath placed;
  placed.toolpath = turned(scannedPlates({scan.box, scan.box}), Eigen::Quaterniond(bedFromLayers().linear()));
  placed.bed_from_part = Eigen::Translation3d(bedFromLayers().translation());
  placed.id = toolpathId(placed.toolpath);
  return toMessage(placed);
}

/// What was seen over level plates, as it is over inclined ones: the sensor goes along with the nozzle.
tf2_msgs::TFMessage onTheBelt(const std::vector<geometry_msgs::TransformStamped>& level) {
  tf2_msgs::TFMessage moving;
  for (const geometry_msgs::TransformStamped& pose : level) {
    const ros::Time& stamp = pose.header.stamp;
    const double belt_mm = kBelt * (stamp.toSec() - 1000.0);
    const Eigen::Isometry3d world_from_bed(Eigen::Translation3d(0.0, -belt_mm, 0.0));
    const Eigen::Isometry3d layers_from_nozzle = fromMessage(pose.transform);
    moving.transforms.push_back(test::stamped(world_from_bed, names::kWorldFrame, names::kBedFrame, stamp));
    moving.transforms.push_back(test::stamped(world_from_bed * bedFromLayers() * layers_from_nozzle,
                                              names::kWorldFrame, names::kNozzleFrame, stamp));
  }
  return moving;
}

class InclinedMonitor : public ::testing::Test {
 protected:
  void SetUp() override {
    const Hears<lamina_msgs::LayerHeight> on_layer = [this](const auto& layer) { layers_.push_back(*layer); };
    const Hears<lamina_msgs::Measuring> on_measuring = [this](const auto& measuring) {
      measured_id_ = measuring->toolpath_id;
    };
    subscribers_ = {node_.subscribe<lamina_msgs::LayerHeight>(names::kLayerHeight, 10, on_layer),
                    node_.subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, on_measuring)};
    ASSERT_TRUE(test::waitUntil([this] {
      return profile_.getNumSubscribers() > 0 && transforms_.getNumSubscribers() > 0 &&
             toolpath_.getNumSubscribers() > 0;
    }));
    tf2_msgs::TFMessage fixed;
    fixed.transforms = {
        test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, ros::Time(1000.0)),
        test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, kFurther, ros::Time(1000.0))};
    publishLatched(fixed_, fixed);
    publishLatched(toolpath_, inclinedPlates());
    ASSERT_TRUE(test::waitUntil([this] { return measured_id_ == inclinedPlates().id; }));
  }

  void send(const test::ScanMessages& messages) {
    for (const auto& cloud : messages.clouds) profile_.publish(cloud);
    transforms_.publish(onTheBelt(messages.transforms));
  }

  ros::NodeHandle node_{"inclined"};
  ros::Publisher toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  ros::Publisher profile_ = node_.advertise<sensor_msgs::PointCloud2>(names::kProfile, 1000);
  ros::Publisher transforms_ = node_.advertise<tf2_msgs::TFMessage>("tf", 1000);
  ros::Publisher fixed_ = node_.advertise<tf2_msgs::TFMessage>("tf_static", 1, true);
  std::vector<ros::Subscriber> subscribers_;
  std::vector<lamina_msgs::LayerHeight> layers_;
  sensor_msgs::PointCloud2::ConstPtr map_;
  std::string measured_id_;
};

TEST_F(InclinedMonitor, MeasuresLayersAlongTheirNormalOnABelt) {
  test::PlateScan scan;
  for (int layer = 0; layer < 2; ++layer) {
    const double top = 0.2 * (layer + 1) + kOffsets[layer];
    scan.nozzle_height_mm = 1.3 + 0.2 * layer;
    scan.surface = [top](const Point2&) { return top; };
    test::ScanMessages messages = test::scanMessages(scan);
    for (auto& cloud : messages.clouds) {
      if (layer == 0) break;
      cloud.header.frame_id = kFurther;
      cloud.header.stamp += ros::Duration(kLate);
    }
    send(messages);
    if (layer == 0) scan.start += ros::Duration(1.0);
  }
  send(test::liftAfter(scan));
  ASSERT_TRUE(test::waitUntil([this] { return layers_.size() == 2; }));
  for (int layer = 0; layer < 2; ++layer) {
    const lamina_msgs::LayerHeight& seen = layers_[static_cast<std::size_t>(layer)];
    EXPECT_EQ(seen.layer, static_cast<std::uint32_t>(layer));
    EXPECT_NEAR(toMillimetres(seen.expected_height), 0.2 * (layer + 1), 1e-9) << "along the normal";
    EXPECT_NEAR(toMillimetres(seen.mean_error), kOffsets[layer], 1e-4);
    EXPECT_NEAR(toMillimetres(seen.worst_error), kOffsets[layer], 1e-3);
    EXPECT_DOUBLE_EQ(seen.coverage, 1.0) << "by a sensor of its own time offset each";
  }
  ros::WallDuration(1.5).sleep();  // beyond the period of the maps, which nobody has asked for yet
  const Hears<sensor_msgs::PointCloud2> on_map = [this](const auto& map) { map_ = map; };
  subscribers_.push_back(node_.subscribe<sensor_msgs::PointCloud2>(names::kHeightMap, 1, on_map));
  ASSERT_TRUE(test::waitUntil([this] { return map_ && map_->width > 15000; })) << "for one who comes late";
  const auto points = fromMessage(*map_, Eigen::Isometry3d::Identity()).points;
  const Eigen::Isometry3d layers_from_bed = bedFromLayers().inverse();
  for (const Point3& point : points) {
    const double height = (layers_from_bed * point).z();
    EXPECT_TRUE(std::abs(height - 0.231) < 0.001 || std::abs(height - 0.383) < 0.001) << height;
  }
}

}  // namespace
}  // namespace lamina
