// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#ifdef LAMINA_HAS_OCTOMAP_MSGS
#include <octomap/OcTree.h>
#include <octomap_msgs/conversions.h>
#endif

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ros/monitor/plate_scan.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

constexpr double kFirstOffset = 0.031;    // mm by which the first plate is too high
constexpr double kSecondOffset = -0.017;  // mm
constexpr double kToolpathStamp = 900.0;  // s
const std::string kFolder = lamina::test::inRosHome("layer_height_monitor_test");

/// Publishes two scans around some bad clouds, once for all tests, and gathers what the node answers.
class LayerHeightMonitorNode : public ::testing::Test {
 protected:
  struct Publishers {
    ros::Publisher toolpath, profile, transforms, fixed_transforms;
  };

  static void SetUpTestSuite() {
    std::filesystem::remove_all(kFolder);
    node_ = new ros::NodeHandle;
    listen();
    to_ = {node_->advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true),
           node_->advertise<sensor_msgs::PointCloud2>(names::kProfile, 1000),
           node_->advertise<tf2_msgs::TFMessage>("/tf", 1000),
           node_->advertise<tf2_msgs::TFMessage>("/tf_static", 1, true)};
    for (const auto& publisher : {to_.toolpath, to_.profile, to_.transforms})
      await([&] { return publisher.getNumSubscribers() > 0; });
    sendToolpath(ros::Time(kToolpathStamp));
    await([] { return counted("toolpath") == test::twoPlates().id; });
    sendAll(to_);
    // Maps come once a second, and may be of the first scan alone.
    await([] { return layers_.size() == 2 && !image_.data.empty() && cloud_.width > 15000; });
#ifdef LAMINA_HAS_OCTOMAP_MSGS
    await([] { return isOccupied(20.05, 0.4 + kSecondOffset); });
#endif
    await([] {
      return counted("layers measured") == "2" && counted("clouds malformed") == "1" &&
             counted("clouds waiting") == "1";
    });
  }

  static void sendToolpath(const ros::Time& stamp) {
    lamina_msgs::Toolpath toolpath = test::twoPlates();
    toolpath.header.stamp = stamp;
    to_.toolpath.publish(toolpath);
    await([&] { return measuring_.toolpath_stamp == stamp; });
  }

#ifdef LAMINA_HAS_OCTOMAP_MSGS
  /// Whether the cell at x [mm], amid the plates, at that height is one of material in the octree.
  static bool isOccupied(double x, double height_mm) {
    if (octomap_.data.empty()) return false;
    const std::unique_ptr<octomap::AbstractOcTree> any(octomap_msgs::msgToMap(octomap_));
    const auto* tree = dynamic_cast<const octomap::OcTree*>(any.get());
    if (tree == nullptr) return false;
    const auto* leaf = tree->search(toMetres(x), toMetres(10.05), toMetres(height_mm));
    return leaf != nullptr && tree->isNodeOccupied(leaf);
  }
#endif

  static void listen() {
    static std::vector<ros::Subscriber> subscribers;
    const boost::function<void(const lamina_msgs::LayerHeightConstPtr&)> onLayer = [](const auto& layer) {
      layers_.push_back(*layer);
    };
    const boost::function<void(const sensor_msgs::ImageConstPtr&)> onImage = [](const auto& image) {
      image_ = *image;
    };
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> onCloud = [](const auto& cloud) {
      cloud_ = *cloud;
    };
    const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> onDiagnostics =
        [](const auto& array) {
          for (const auto& status : array->status)
            if (status.name.rfind("layer_height_monitor", 0) == 0)
              for (const auto& value : status.values) diagnostics_[value.key] = value.value;
        };
    const boost::function<void(const lamina_msgs::MeasuringConstPtr&)> onMeasuring =
        [](const auto& measuring) { measuring_ = *measuring; };
    subscribers = {node_->subscribe<lamina_msgs::Measuring>(names::kMeasuring, 1, onMeasuring),
                   node_->subscribe<lamina_msgs::LayerHeight>(names::kLayerHeight, 10, onLayer),
                   node_->subscribe<sensor_msgs::Image>(names::kHeightDeviation, 1, onImage),
                   node_->subscribe<sensor_msgs::PointCloud2>(names::kHeightMap, 1, onCloud),
                   node_->subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10, onDiagnostics)};
#ifdef LAMINA_HAS_OCTOMAP_MSGS
    const boost::function<void(const octomap_msgs::OctomapConstPtr&)> onOctomap = [](const auto& octomap) {
      octomap_ = *octomap;
    };
    subscribers.push_back(node_->subscribe<octomap_msgs::Octomap>(names::kHeightOctomap, 1, onOctomap));
#endif
  }

  static void sendAll(const Publishers& to) {
    tf2_msgs::TFMessage fixed;
    fixed.transforms = {
        test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, ros::Time::now())};
    to.fixed_transforms.publish(fixed);
    test::PlateScan scan;
    scan.start = ros::Time::now();
    scan.surface = [](const Point2&) { return 0.2 + kFirstOffset; };
    send(to, scan);
    sendBadClouds(to.profile, scan.start);
    scan.start += ros::Duration(1.0);
    scan.nozzle_height_mm = 1.5;
    scan.surface = [](const Point2& at) { return at.x() < 10 ? NAN : 0.4 + kSecondOffset; };
    send(to, scan);
    const test::ScanMessages lift = test::liftAfter(scan);
    send(to, lift);
    end_ = lift.clouds.back().header.stamp;
  }

  /// The nozzle alone, somewhere over the plates.
  static void sendNozzle(const ros::Time& stamp, double height_mm) {
    tf2_msgs::TFMessage moving;
    moving.transforms = {
        test::stamped(test::bedFromNozzle({0, 10, height_mm}), names::kBedFrame, names::kNozzleFrame, stamp)};
    to_.transforms.publish(moving);
  }

  static lamina_msgs::FinishMeasuringResponse finish(const ros::Time& position, const ros::Time& profile) {
    lamina_msgs::FinishMeasuring call;
    call.request.toolpath_id = test::twoPlates().id;
    call.request.last_position = position;
    call.request.last_profile = profile;
    EXPECT_TRUE(callService(names::kFinishMeasuring, call));
    EXPECT_EQ(call.response.status.message, "");
    return call.response;
  }

  static void send(const Publishers& to, const test::PlateScan& scan) { send(to, test::scanMessages(scan)); }

  static void send(const Publishers& to, const test::ScanMessages& messages) {
    for (const auto& cloud : messages.clouds) to.profile.publish(cloud);
    tf2_msgs::TFMessage moving;
    moving.transforms = messages.transforms;
    to.transforms.publish(moving);
  }

  static void sendBadClouds(const ros::Publisher& profile, const ros::Time& stamp) {
    sensor_msgs::PointCloud2 cloud = toCloudMessage({Point3(1, 2, 3)});
    cloud.header.stamp = stamp;
    profile.publish(cloud);  // without a frame
    cloud.header.frame_id = "nowhere";
    profile.publish(cloud);
    cloud.header.frame_id = names::kSensorFrame;
    cloud.header.stamp = ros::Time();
    profile.publish(cloud);  // of no time
    cloud.header.stamp = stamp;
    cloud.fields.pop_back();
    profile.publish(cloud);  // without z
  }

  static void await(const std::function<bool()>& condition) { test::waitUntil(condition); }

  static std::string counted(const std::string& key) { return diagnostics_[key]; }

  static ros::NodeHandle* node_;
  static Publishers to_;
  static ros::Time end_;  ///< of the second scan
  static lamina_msgs::Measuring measuring_;
  static std::vector<lamina_msgs::LayerHeight> layers_;
  static sensor_msgs::Image image_;
  static sensor_msgs::PointCloud2 cloud_;
#ifdef LAMINA_HAS_OCTOMAP_MSGS
  static octomap_msgs::Octomap octomap_;
#endif
  static std::map<std::string, std::string> diagnostics_;
};

ros::NodeHandle* LayerHeightMonitorNode::node_ = nullptr;
LayerHeightMonitorNode::Publishers LayerHeightMonitorNode::to_;
ros::Time LayerHeightMonitorNode::end_;
lamina_msgs::Measuring LayerHeightMonitorNode::measuring_;
std::vector<lamina_msgs::LayerHeight> LayerHeightMonitorNode::layers_;
sensor_msgs::Image LayerHeightMonitorNode::image_;
sensor_msgs::PointCloud2 LayerHeightMonitorNode::cloud_;
#ifdef LAMINA_HAS_OCTOMAP_MSGS
octomap_msgs::Octomap LayerHeightMonitorNode::octomap_;
#endif
std::map<std::string, std::string> LayerHeightMonitorNode::diagnostics_;

TEST_F(LayerHeightMonitorNode, ReportsTheKnownOffsetOfEachLayer) {
  ASSERT_EQ(layers_.size(), 2u);
  EXPECT_EQ(layers_[0].layer, 0u);
  EXPECT_EQ(layers_[1].layer, 1u);
  EXPECT_EQ(layers_[0].toolpath_id, test::twoPlates().id);
  // Single precision of metres at a distance of 60 mm.
  EXPECT_NEAR(toMillimetres(layers_[0].expected_height), 0.2, 1e-9);
  EXPECT_NEAR(toMillimetres(layers_[0].mean_error), kFirstOffset, 1e-5);
  EXPECT_NEAR(toMillimetres(layers_[0].worst_error), kFirstOffset, 1e-4);
  EXPECT_DOUBLE_EQ(layers_[0].coverage, 1.0);
  EXPECT_NEAR(toMillimetres(layers_[1].mean_error), kSecondOffset, 1e-5);
}

TEST_F(LayerHeightMonitorNode, AnUnseenQuarterLowersTheCoverage) {
  ASSERT_EQ(layers_.size(), 2u);
  EXPECT_NEAR(layers_[1].coverage, 0.75, 0.01);
}

TEST_F(LayerHeightMonitorNode, CountsBadCloudsAndLivesOn) {
  EXPECT_EQ(counted("clouds without frame or stamp"), "2");
  EXPECT_EQ(counted("clouds malformed"), "1");
  EXPECT_EQ(counted("clouds waiting"), "1");  // for a frame nobody knows
  EXPECT_EQ(counted("clouds lost on the way"), "0");
  EXPECT_EQ(counted("clouds without transform"), "0");
  EXPECT_GT(std::stoul(counted("points not finite")), 1000u);
}

TEST_F(LayerHeightMonitorNode, AccountsForEveryProfileAndPoint) {
  ASSERT_EQ(layers_.size(), 2u);
  for (const auto& layer : layers_) EXPECT_EQ(layer.sight, lamina_msgs::LayerHeight::SEEN + 0);
  const lamina_msgs::ProfileCounts& of = layers_.back().counts;
  EXPECT_EQ(of.received, of.of_layers + of.of_no_layer + of.waiting + of.without_frame + of.malformed +
                             of.without_transform + of.without_nozzle + of.pushed_out + of.in_gap + of.late);
  EXPECT_EQ(of.points_received, of.points_used + of.points_outside + of.points_not_finite +
                                    of.points_dropped + of.points_waiting);
  EXPECT_EQ(of.of_layers, layers_[0].profiles + layers_[1].profiles);
  EXPECT_EQ(of.malformed, 1u);
  EXPECT_EQ(of.without_frame, 2u);
  EXPECT_EQ(of.late + of.in_gap + of.lost, 0u);
}

TEST_F(LayerHeightMonitorNode, PublishesTheMaps) {
  EXPECT_EQ(cloud_.header.frame_id, names::kBedFrame);
  EXPECT_EQ(cloud_.fields.back().name, "deviation");
  EXPECT_GT(cloud_.width, 15000u);
  EXPECT_EQ(image_.encoding, "32FC1");
  EXPECT_EQ(image_.width, 256u);  // 19.6 mm between the outermost centre lines and 3 mm on either side
}

#ifdef LAMINA_HAS_OCTOMAP_MSGS
TEST_F(LayerHeightMonitorNode, PublishesTheMapAsAnOctree) {
  EXPECT_EQ(octomap_.header.frame_id, names::kBedFrame);
  const std::unique_ptr<octomap::AbstractOcTree> any(octomap_msgs::msgToMap(octomap_));
  const auto* tree = dynamic_cast<const octomap::OcTree*>(any.get());
  ASSERT_NE(tree, nullptr);
  EXPECT_DOUBLE_EQ(tree->getResolution(), 1e-4) << "cells of 0.1 mm";
  // Only the first scan saw x = 7 mm, the second one was over x = 20 mm.
  EXPECT_TRUE(isOccupied(7.05, 0.2 + kFirstOffset));
  EXPECT_FALSE(isOccupied(7.05, 0.4 + kSecondOffset));
  EXPECT_TRUE(isOccupied(20.05, 0.4 + kSecondOffset));
}
#endif

TEST_F(LayerHeightMonitorNode, SavesItsFilesOnRequest) {
  std_srvs::Trigger request;
  ASSERT_TRUE(callService(names::kSaveHeightMap, request));
  EXPECT_TRUE(request.response.success) << request.response.message;
  for (const char* name : {"height_map.png", "deviation.png", "height_map.bt", "layer_heights.csv"})
    EXPECT_TRUE(std::filesystem::exists(kFolder + "/" + name)) << name;
}

TEST_F(LayerHeightMonitorNode, StatesWhatItMeasuresOnceAllIsConnected) {
  EXPECT_EQ(measuring_.toolpath_id, test::twoPlates().id);
  EXPECT_EQ(measuring_.toolpath_stamp, ros::Time(kToolpathStamp));
}

TEST_F(LayerHeightMonitorNode, FinishesOnceTransformsAndProfilesHaveComeSoFar) {
  EXPECT_FALSE(finish(end_ + ros::Duration(1.0), end_).is_finished) << "tf has not come so far";
  EXPECT_FALSE(finish(end_, end_ + ros::Duration(1.0)).is_finished) << "no profile has";
  const lamina_msgs::FinishMeasuringResponse done = finish(end_, end_);
  EXPECT_TRUE(done.is_finished);
  ASSERT_EQ(done.layers.size(), 2u);
  EXPECT_EQ(done.layers[1].layer, 1u);
  EXPECT_EQ(done.layers[1].mean_error, layers_[1].mean_error);
  EXPECT_EQ(done.counts.waiting, 1u) << "for a frame nobody knows";
}

TEST_F(LayerHeightMonitorNode, FinishesNoOtherToolpath) {
  lamina_msgs::FinishMeasuring call;
  call.request.toolpath_id = "another";
  ASSERT_TRUE(callService(names::kFinishMeasuring, call));
  EXPECT_EQ(call.response.status.code, lamina_msgs::Status::REJECTED + 0);
  EXPECT_FALSE(call.response.is_finished);
}

TEST_F(LayerHeightMonitorNode, LogsWhichRequestFailed) {
  std::vector<std::string> lines;
  const boost::function<void(const rosgraph_msgs::LogConstPtr&)> onLog =
      [&](const rosgraph_msgs::LogConstPtr& message) { lines.push_back(message->msg); };
  const ros::Subscriber rosout = node_->subscribe<rosgraph_msgs::Log>("/rosout", 1000, onLog);
  // What was logged before this test heard the node is lost.
  EXPECT_TRUE(test::waitUntil([&] {
    lamina_msgs::FinishMeasuring call;
    call.request.toolpath_id = "another";
    callService(names::kFinishMeasuring, call);
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.rfind("cannot finish measuring toolpath 'another': Rejected: ", 0) == 0;
    });
  }));
}

TEST_F(LayerHeightMonitorNode, ALastLayerThatWasMissedIsNotSeenAndAWaitingCloudIsNotTheNextPrints) {
  sendToolpath(ros::Time(kToolpathStamp + 1.0));
  await([] { return counted("clouds of the print before") == "1"; });
  test::PlateScan scan;
  scan.start = end_ + ros::Duration(1.0);
  scan.surface = [](const Point2&) { return 0.2; };
  send(to_, scan);
  const ros::Time printed = scan.start + ros::Duration(1.0);
  for (const double after_s : {0.0, 0.1, 0.2}) sendNozzle(printed + ros::Duration(after_s), 0.4);
  const ros::Time last_profile = test::scanMessages(scan).clouds.back().header.stamp;
  lamina_msgs::FinishMeasuringResponse done;
  await([&] {
    done = finish(printed + ros::Duration(0.2), last_profile);
    return done.is_finished != 0;
  });
  ASSERT_EQ(done.layers.size(), 2u);
  EXPECT_EQ(done.layers[0].sight, lamina_msgs::LayerHeight::SEEN + 0);
  EXPECT_EQ(done.layers[1].sight, lamina_msgs::LayerHeight::NOT_SEEN + 0);
  EXPECT_EQ(done.counts.waiting, 0u);
  EXPECT_EQ(done.counts.received, test::scanMessages(scan).clouds.size());
}

/// Driven once more without being announced again: the figures of the part before are none of this one.
TEST_F(LayerHeightMonitorNode, MeasuresTheNextPartOfTheSameToolpath) {
  sendToolpath(ros::Time(kToolpathStamp + 2.0));
  test::PlateScan scan;
  scan.start = end_ + ros::Duration(10.0);
  scan.surface = [](const Point2&) { return 0.2; };
  const std::size_t before = layers_.size();
  send(to_, scan);
  send(to_, test::liftAfter(scan));
  await([&] { return layers_.size() > before && counted("profiles of layers") != "0"; });
  ros::Publisher machine = node_->advertise<lamina_msgs::MachineState>(names::kMachineState, 10);
  await([&] { return machine.getNumSubscribers() > 0; });
  lamina_msgs::MachineState state;
  for (const std::uint8_t each : {lamina_msgs::MachineState::EXECUTE, lamina_msgs::MachineState::COMPLETE,
                                  lamina_msgs::MachineState::STARTING}) {
    state.state = each;
    machine.publish(state);
  }
  await([] { return counted("profiles of layers") == "0"; });
  scan.start += ros::Duration(20.0);
  scan.surface = [](const Point2&) { return 0.25; };
  send(to_, scan);
  const test::ScanMessages lift = test::liftAfter(scan);
  send(to_, lift);
  lamina_msgs::FinishMeasuringResponse done;
  await([&] {
    done = finish(lift.transforms.back().header.stamp, lift.clouds.back().header.stamp);
    return done.is_finished != 0;
  });
  ASSERT_EQ(done.layers.size(), 1u);
  EXPECT_NEAR(toMillimetres(done.layers[0].mean_error), 0.05, 1e-5);
}

}  // namespace
}  // namespace lamina
