// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The layer_height_monitor in the namespace `bounded`: its queue holds 10 MB, its maps come every 2 s.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <map>

#include "lamina/base/clock.hpp"
#include "latched.hpp"
#include "plate_scan.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

const std::string kName = "bounded/layer_height_monitor";
constexpr double kMapPeriod = 2.0;  // s

template <class Message>
using Heard = boost::function<void(const boost::shared_ptr<const Message>&)>;

class BoundedMonitor : public ::testing::Test {
 protected:
  void SetUp() override {
    const Heard<diagnostic_msgs::DiagnosticArray> on_diagnostics = [this](const auto& array) {
      for (const auto& status : array->status)
        if (status.name.rfind(kName, 0) == 0)
          for (const auto& value : status.values) counted_[value.key] = value.value;
    };
    const Heard<rosgraph_msgs::Log> on_log = [this](const auto& log) {
      if (log->name == "/" + kName) logged_.push_back(log->msg);
    };
    const Heard<sensor_msgs::PointCloud2> on_map = [this](const auto&) { ++maps_; };
    const Heard<lamina_msgs::Measuring> on_measuring = [this](const auto& measuring) {
      measured_id_ = measuring->toolpath_id;
    };
    subscribers_ = {node_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, on_diagnostics),
                    node_.subscribe<rosgraph_msgs::Log>("/rosout", 1000, on_log),
                    node_.subscribe<sensor_msgs::PointCloud2>(names::kHeightMap, 10, on_map),
                    node_.subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, on_measuring)};
    ASSERT_TRUE(test::waitUntil([this] {
      return profile_.getNumSubscribers() > 0 && transforms_.getNumSubscribers() > 0 &&
             subscribers_[2].getNumPublishers() > 0 && !counted_.empty();
    }));
  }

  /// Has the node refuse something until its log is heard here.
  void awaitLog() {
    std_srvs::Trigger refused;  // without an output folder
    ASSERT_TRUE(test::waitUntil([&] {
      return ros::service::call("bounded/" + std::string(names::kSaveHeightMap), refused) && !logged_.empty();
    }));
  }

  /// Clouds in a frame that tf never places.
  void sendUnplaced(std::size_t clouds, std::size_t points) {
    sensor_msgs::PointCloud2 cloud = toCloudMessage(std::vector<Point3>(points, Point3(1, 2, 3)));
    cloud.header.frame_id = "nowhere";
    for (std::size_t i = 0; i < clouds; ++i) {
      cloud.header.stamp = stamp_ += ros::Duration(0.001);
      profile_.publish(cloud);
    }
  }

  /// A profile of the first plate, and where the nozzle was.
  void sendProfile() {
    test::PlateScan scan;
    scan.box = {Point2(5, 5), Point2(25, 5)};
    scan.surface = [](const Point2&) { return 0.2; };
    const test::ScanMessages messages = test::scanMessages(scan);
    sensor_msgs::PointCloud2 cloud = messages.clouds.front();
    tf2_msgs::TFMessage moving;
    moving.transforms = {messages.transforms.front()};
    moving.transforms[0].header.stamp = cloud.header.stamp = stamp_ += ros::Duration(0.001);
    transforms_.publish(moving);
    profile_.publish(cloud);
  }

  ros::NodeHandle node_{"bounded"};
  ros::Publisher toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  ros::Publisher profile_ = node_.advertise<sensor_msgs::PointCloud2>(names::kProfile, 1000);
  ros::Publisher transforms_ = node_.advertise<tf2_msgs::TFMessage>("tf", 1000);
  ros::Publisher fixed_ = node_.advertise<tf2_msgs::TFMessage>("tf_static", 1, true);
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, std::string> counted_;
  std::vector<std::string> logged_;
  std::string measured_id_;
  int maps_ = 0;
  ros::Time stamp_{1000.0};
};

TEST_F(BoundedMonitor, PublishesMapsNoOftenerThanItsPeriod) {
  tf2_msgs::TFMessage fixed;
  fixed.transforms = {
      test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, stamp_)};
  publishLatched(fixed_, fixed);
  publishLatched(toolpath_, test::twoPlates());
  ASSERT_TRUE(test::waitUntil([this] { return measured_id_ == test::twoPlates().id; }));
  const SteadyClock clock;
  const double begin = clock.now();
  ASSERT_TRUE(test::waitUntil([this] {
    sendProfile();
    return maps_ >= 2;
  }));
  EXPECT_GE(clock.now() - begin, kMapPeriod) << "between the first map and the second";
}

TEST_F(BoundedMonitor, CloudsThatTakeMoreMemoryThanTheQueueMayPushOutTheOldest) {
  awaitLog();
  sendUnplaced(100, 10);
  ASSERT_TRUE(test::waitUntil([this] { return counted_["clouds waiting"] == "100"; }));
  EXPECT_EQ(counted_["clouds pushed out"], "0") << "they take less than 0.1 MB";
  sendUnplaced(20, 100000);
  // Each of 1.2 MB, and a little more for a message: 8 fit into 10 MB, all small ones and 12 have to go.
  ASSERT_TRUE(test::waitUntil([this] { return counted_["clouds pushed out"] == "112"; }));
  EXPECT_EQ(counted_["clouds waiting"], "8");
  EXPECT_NEAR(std::stod(counted_["bytes of clouds waiting"]), 8 * 1.2e6, 8 * 1000);
  ASSERT_TRUE(
      test::waitUntil([this] { return logged_.back().find("clouds that wait") != std::string::npos; }));
  EXPECT_EQ(logged_.back().rfind("109 clouds that wait for tf take 108", 0), 0U) << logged_.back();
  EXPECT_NE(logged_.back().find("at most queue_mb = 10 MB"), std::string::npos) << logged_.back();
}

}  // namespace
}  // namespace lamina
