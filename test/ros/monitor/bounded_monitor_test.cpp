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
#include <memory>

#include "lamina/base/clock.hpp"
#include "latched.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

const std::string kName = "bounded/layer_height_monitor";
constexpr double kMapPeriod = 2.0;  // s

template <class Message>
using Heard = boost::function<void(const boost::shared_ptr<const Message>&)>;

/// What feeds the node. One for all tests: a topic that is advertised anew may lose messages while its
/// subscriber still drops the connection of before.
struct Feed {
  ros::NodeHandle node{"bounded"};
  ros::Publisher toolpath = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  ros::Publisher profile = node.advertise<sensor_msgs::PointCloud2>(names::kProfile, 1000);
  ros::Publisher transforms = node.advertise<tf2_msgs::TFMessage>("tf", 1000);
  ros::Publisher fixed = node.advertise<tf2_msgs::TFMessage>("tf_static", 1, true);
  ros::Time stamp{1000.0};
};

class BoundedMonitor : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { feed = std::make_unique<Feed>(); }
  static void TearDownTestSuite() { feed.reset(); }

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
    subscribers_ = {
        feed->node.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, on_diagnostics),
        feed->node.subscribe<rosgraph_msgs::Log>("/rosout", 1000, on_log),
        feed->node.subscribe<sensor_msgs::PointCloud2>(names::kHeightMap, 10, on_map),
        feed->node.subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, on_measuring)};
    ASSERT_TRUE(test::waitUntil([this] {
      return feed->profile.getNumSubscribers() > 0 && feed->transforms.getNumSubscribers() > 0 &&
             subscribers_[2].getNumPublishers() > 0 && !counted_.empty();
    }));
  }

  /// Has the node refuse something until its log is heard here.
  void awaitLog() {
    std_srvs::Trigger refused;  // without an output folder
    ASSERT_TRUE(test::waitUntil([&] {
      return callService("bounded/" + std::string(names::kSaveHeightMap), refused) && !logged_.empty();
    }));
  }

  /// Clouds in a frame that tf never places.
  void sendUnplaced(std::size_t clouds, std::size_t points) {
    sensor_msgs::PointCloud2 cloud = toCloudMessage(std::vector<Point3>(points, Point3(1, 2, 3)));
    cloud.header.frame_id = "nowhere";
    for (std::size_t i = 0; i < clouds; ++i) {
      cloud.header.stamp = feed->stamp += ros::Duration(0.001);
      feed->profile.publish(cloud);
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
    moving.transforms[0].header.stamp = cloud.header.stamp = feed->stamp += ros::Duration(0.001);
    feed->transforms.publish(moving);
    feed->profile.publish(cloud);
  }

  static inline std::unique_ptr<Feed> feed;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, std::string> counted_;
  std::vector<std::string> logged_;
  std::string measured_id_;
  int maps_ = 0;
};

TEST_F(BoundedMonitor, PublishesMapsNoOftenerThanItsPeriod) {
  tf2_msgs::TFMessage fixed;
  fixed.transforms = {
      test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, feed->stamp)};
  publishLatched(feed->fixed, fixed);
  // The first map may go out as soon as the toolpath is there.
  const SteadyClock clock;
  const double begin = clock.now();
  publishLatched(feed->toolpath, test::twoPlates());
  ASSERT_TRUE(test::waitUntil([this] { return measured_id_ == test::twoPlates().id; }));
  ASSERT_TRUE(test::waitUntil([this] {
    sendProfile();
    return maps_ >= 2;
  }));
  EXPECT_GE(clock.now() - begin, kMapPeriod) << "between the first map and the second";
  EXPECT_TRUE(test::waitUntil([this] { return counted_["clouds waiting"] == "0"; }))
      << counted_["clouds waiting"];
}

TEST_F(BoundedMonitor, CloudsThatTakeMoreMemoryThanTheQueueMayPushOutTheOldest) {
  awaitLog();
  sendUnplaced(100, 10);
  ASSERT_TRUE(test::waitUntil([this] { return counted_["clouds waiting"] == "100"; }))
      << counted_["clouds waiting"];
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
