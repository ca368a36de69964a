// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Streams programs to the node emulated_machine and looks at what it publishes.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <vector>

#include "lamina/streaming/session/stream_session.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace {

using lamina::test::kPatience;
using lamina::test::waitUntil;

const std::string kPort = lamina::test::inRosHome("emulated_machine_test");
constexpr double kSpeedUp = 10.0;

template <class Message>
using Messages = std::vector<boost::shared_ptr<const Message>>;

/// A callback that keeps every message.
template <class Message>
boost::function<void(const boost::shared_ptr<const Message>&)> into(Messages<Message>& all) {
  return [&all](const boost::shared_ptr<const Message>& message) { all.push_back(message); };
}

class EmulatedMachineNode : public testing::Test {
 protected:
  void SetUp() override {
    ros::NodeHandle node;
    position_subscriber_ =
        node.subscribe<sensor_msgs::JointState>(lamina::names::kMachinePosition, 20000, into(positions_));
    profile_subscriber_ =
        node.subscribe<sensor_msgs::PointCloud2>(lamina::names::kProfile, 20000, into(profiles_));
    deposited_subscriber_ =
        node.subscribe<sensor_msgs::PointCloud2>(lamina::names::kDeposited, 100, into(deposited_));
    ASSERT_TRUE(waitUntil([&] {
      return position_subscriber_.getNumPublishers() > 0 && profile_subscriber_.getNumPublishers() > 0 &&
             !positions_.empty();
    }));
  }

  static void stream(const std::string& text) {
    const auto program = lamina::StreamableProgram::fromText("test", text);
    const lamina::StreamSession session(program, {}, {kPort, 115200}, {});
    ASSERT_TRUE(session.waitFor(kPatience));
    ASSERT_EQ(session.status().state, lamina::PackmlState::Complete) << session.status().failure.message;
  }
  bool isAt(double x, double y) const {
    const auto& p = positions_.back()->position;
    return std::abs(p[0] - x) < 1e-9 && std::abs(p[1] - y) < 1e-9;
  }

  std::vector<sensor_msgs::JointState::ConstPtr> positions_;
  std::vector<sensor_msgs::PointCloud2::ConstPtr> profiles_;
  std::vector<sensor_msgs::PointCloud2::ConstPtr> deposited_;
  ros::Subscriber position_subscriber_;
  ros::Subscriber profile_subscriber_;
  ros::Subscriber deposited_subscriber_;
};

TEST_F(EmulatedMachineNode, ReportsPositionsAtEveryMillimetreWithExactStamps) {
  stream("G28\nG90\nG1 X50 Y50 Z0.3 F6000\nG4 P200\n");
  ASSERT_TRUE(waitUntil([&] { return isAt(0.05, 0.05); }));
  positions_.clear();
  stream("G1 X150 F6000\n");  // 100 mm at 100 mm/s
  ASSERT_TRUE(waitUntil([&] { return !positions_.empty() && isAt(0.15, 0.05); }));
  EXPECT_GE(positions_.size(), 100U);
  EXPECT_LE(positions_.size(), 103U);
  EXPECT_EQ(positions_.front()->name, (std::vector<std::string>{"x", "y", "z"}));
  // At constant speed in the middle: 50 mm take 0.5 s of machine time.
  const auto at = [&](double x) {
    for (const auto& position : positions_) {
      if (std::abs(position->position[0] - x) < 1e-9) return position->header.stamp;
    }
    ADD_FAILURE() << "no position at " << x;
    return ros::Time();
  };
  EXPECT_NEAR((at(0.125) - at(0.075)).toSec(), 0.5 / kSpeedUp, 1e-6);
  for (std::size_t i = 1; i < positions_.size(); ++i) {
    EXPECT_LE(positions_[i - 1]->header.stamp, positions_[i]->header.stamp);
    EXPECT_LE(positions_[i]->position[0] - positions_[i - 1]->position[0], 1e-3 + 1e-9);
  }
}

TEST_F(EmulatedMachineNode, KeepsWhatItDepositsAndSeesItWithItsSensor) {
  // A bead of 0.4 mm x 0.3 mm over 40 mm takes 1.9 mm of filament of 1.75 mm.
  stream("G28\nG90\nM83\nG1 X60 Y60 Z0.3 F6000\nG1 X100 E1.9 F1800\n");
  ASSERT_TRUE(waitUntil([&] { return !deposited_.empty() && !deposited_.back()->data.empty(); }));
  const auto material = lamina::fromMessage(*deposited_.back(), Eigen::Isometry3d::Identity());
  EXPECT_EQ(deposited_.back()->header.frame_id, "bed");
  for (const auto& point : material.points) {
    EXPECT_GT(point.x(), 58.0);
    EXPECT_LT(point.x(), 102.0);
    EXPECT_NEAR(point.y(), 60.0, 1.0);
    EXPECT_LE(point.z(), 0.3 + 1e-6);
  }
  stream("G1 Z2 F6000\nG1 X55 Y70 F6000\n");  // the sensor looks 25 mm beside the nozzle, at x = 80
  ASSERT_TRUE(waitUntil([&] { return isAt(0.055, 0.07); }));
  const ros::Time over = positions_.back()->header.stamp;
  stream("G1 Y50 F3000\n");  // 20 mm: 20 profiles
  ASSERT_TRUE(waitUntil([&] {
    return isAt(0.055, 0.05) && profiles_.back()->header.stamp == positions_.back()->header.stamp;
  }));
  double highest = 0.0;
  int count = 0;
  for (const auto& profile : profiles_) {
    if (profile->header.stamp <= over) continue;
    ++count;
    EXPECT_EQ(profile->header.frame_id, "sensor");
    const auto points = lamina::fromMessage(*profile, Eigen::Isometry3d::Identity()).points;
    for (const auto& point : points)
      highest = std::max(highest, 62.0 - point.z());  // the sensor is at z = 62 mm
    const auto is_same_stamp = [&](const auto& position) {
      return position->header.stamp == profile->header.stamp;
    };
    EXPECT_TRUE(std::any_of(positions_.begin(), positions_.end(), is_same_stamp));
  }
  EXPECT_EQ(count, 20);
  EXPECT_NEAR(highest, 0.3, 0.1);  // five standard deviations of the sensor's noise and more
}

TEST_F(EmulatedMachineNode, RestsOnceAllMotionsArePublishedAndStatesTheirLastStamps) {
  lamina_msgs::MachineRest rest;
  stream("G28\nG90\nG1 X50 Y50 Z5 F6000\nG1 X60 F600\n");
  ASSERT_TRUE(waitUntil(
      [&] { return lamina::callService(lamina::names::kMachineRest, rest) && rest.response.is_resting; }));
  const ros::Time last = rest.response.last_position;
  ASSERT_TRUE(waitUntil([&] { return positions_.back()->header.stamp >= last; }));
  EXPECT_EQ(positions_.back()->header.stamp, last);
  EXPECT_TRUE(isAt(0.06, 0.05)) << "nothing is left to come";
  EXPECT_EQ(rest.response.last_profile, last) << "the end of a motion has a profile, of nothing too";
}

}  // namespace
