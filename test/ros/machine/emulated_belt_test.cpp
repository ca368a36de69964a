// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An emulated belt printer: what it deposits is on the belt, and the belt carries it along.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <cmath>

#include "lamina/streaming/session/stream_session.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "tf/transform_intake.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

void stream(const std::string& text) {
  const auto program = StreamableProgram::fromText("test", text);
  const StreamSession session(program, {}, {test::inRosHome("emulated_belt_test"), 115200}, {});
  ASSERT_TRUE(session.waitFor(test::kPatience));
  ASSERT_EQ(session.status().state, PackmlState::Complete) << session.status().failure.message;
}

TEST(EmulatedBelt, WhatIsDepositedLiesOnTheBeltAndMovesWithIt) {
  ros::NodeHandle node;
  sensor_msgs::PointCloud2::ConstPtr deposited;
  sensor_msgs::JointState::ConstPtr position;
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_deposited =
      [&](const auto& message) { deposited = message; };
  const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_position = [&](const auto& message) {
    position = message;
  };
  const auto clouds = node.subscribe<sensor_msgs::PointCloud2>(names::kDeposited, 100, on_deposited);
  const auto positions = node.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 20000, on_position);
  tf2::BufferCore buffer(ros::Duration(3600.0));
  const TransformIntake intake(buffer, node);
  ASSERT_TRUE(test::waitUntil([&] { return position && clouds.getNumPublishers() > 0; }));

  // 0.5 mm up the gantry at 45 deg, with the belt 20 mm forth: z = 0.354 mm and y = 0.354 - 20 mm over the
  // bed.
  stream("G90\nM83\nG1 X50 Y0.5 Z20 F6000\nG1 X90 E3 F1800\n");
  std::vector<Point3> points;
  ASSERT_TRUE(test::waitUntil([&] {
    if (deposited) points = fromMessage(*deposited, Eigen::Isometry3d::Identity()).points;
    // What is published first may be the beginning of the bead.
    return points.size() > 80U;
  }));
  EXPECT_EQ(deposited->header.frame_id, names::kBedFrame);
  const double height = 0.5 * M_SQRT1_2;
  for (const Point3& point : points) {
    EXPECT_GT(point.x(), 47.0);
    EXPECT_LT(point.x(), 93.0);
    EXPECT_NEAR(point.y(), height - 20.0, 3.0);
    EXPECT_LE(point.z(), height + 1e-6);
  }
  const auto reached = [&](double x, double z) {
    return std::abs(position->position[0] - x) < 1e-9 && std::abs(position->position[2] - z) < 1e-9;
  };
  ASSERT_TRUE(test::waitUntil([&] { return reached(0.09, 0.02); }));
  const auto bedAt = [&](const ros::Time& stamp) -> Point3 {
    std::optional<Eigen::Isometry3d> bed;
    EXPECT_TRUE(test::waitUntil([&] {
      bed = lookUp(buffer, names::kWorldFrame, names::kBedFrame, stamp);
      return bed.has_value();
    }));
    return bed->translation();
  };
  const Point3 before = bedAt(position->header.stamp);
  stream("G1 Z30 F6000\n");
  ASSERT_TRUE(test::waitUntil([&] { return reached(0.09, 0.03); }));
  const Point3 along = bedAt(position->header.stamp) - before;
  EXPECT_NEAR(along.norm(), 10.0, 1e-9) << "the belt has carried the bed";
  const auto nozzle = lookUp(buffer, names::kBedFrame, names::kNozzleFrame, position->header.stamp);
  ASSERT_TRUE(nozzle);
  EXPECT_LT((nozzle->translation() - Point3(90.0, height - 30.0, height)).norm(), 1e-6);
}

}  // namespace
}  // namespace lamina
