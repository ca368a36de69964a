// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

#include "ros/bag_player.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

void write(rosbag::Bag& bag, const test::ScanMessages& messages) {
  for (const auto& cloud : messages.clouds) bag.write(names::kProfile, cloud.header.stamp, cloud);
  for (const auto& transform : messages.transforms) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform};
    // Late, as transforms are: the clouds have to wait for theirs.
    bag.write("/tf", transform.header.stamp + ros::Duration(0.02), message);
  }
}

/// The print of two plates, recorded long ago: the first is flat and 0.05 mm too low, the second rises along
/// x by 0.004 mm per mm about the middle of the plate, where it is right.
void writeBag(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::LZ4);
  test::PlateScan scan;
  bag.write(names::kToolpath, scan.start - ros::Duration(2.0), test::twoPlates());
  tf2_msgs::TFMessage fixed;
  fixed.transforms = {
      test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, scan.start)};
  bag.write("/tf_static", scan.start - ros::Duration(1.9), fixed);
  scan.surface = [](const Point2&) { return 0.15; };
  write(bag, test::scanMessages(scan));
  scan.start += ros::Duration(1.0);
  scan.nozzle_height_mm = 1.5;
  scan.surface = [](const Point2& at) { return 0.4 + 0.004 * (at.x() - 15.0); };
  write(bag, test::scanMessages(scan));
  write(bag, test::liftAfter(scan));
}

TEST(LayerHeightBag, AReplayedPrintHasTheKnownHeights) {
  ros::NodeHandle node;
  std::vector<lamina_msgs::LayerHeight> layers;
  const boost::function<void(const lamina_msgs::LayerHeightConstPtr&)> onLayer = [&](const auto& layer) {
    layers.push_back(*layer);
  };
  const auto subscriber = node.subscribe<lamina_msgs::LayerHeight>(names::kLayerHeight, 10, onLayer);
  const test::ScratchFolder folder;
  writeBag(folder.file("print.bag"));
  const test::BagPlayer player(folder.file("print.bag"), {"--delay=1"});
  test::waitUntil([&] { return layers.size() >= 2; });
  ASSERT_EQ(layers.size(), 2u);
  for (const auto& layer : layers) EXPECT_EQ(layer.sight, lamina_msgs::LayerHeight::SEEN + 0);
  EXPECT_NEAR(toMillimetres(layers[0].mean_error), -0.05, 1e-5);
  EXPECT_NEAR(toMillimetres(layers[0].rms_error), 0.05, 1e-5);
  EXPECT_DOUBLE_EQ(layers[0].coverage, 1.0);
  const double width = 19.6 + 0.2;  // of the flat tops
  EXPECT_NEAR(toMillimetres(layers[1].mean_error), 0.0, 1e-3);
  EXPECT_NEAR(toMillimetres(layers[1].rms_error), 0.004 * width / std::sqrt(12.0), 1e-3);
  EXPECT_NEAR(std::abs(toMillimetres(layers[1].worst_error)), 0.004 * 0.5 * width, 1e-3);
  EXPECT_DOUBLE_EQ(layers[1].coverage, 1.0);
}

}  // namespace
}  // namespace lamina
