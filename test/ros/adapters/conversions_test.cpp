// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "point_cloud.hpp"

namespace {

using lamina::MachineToolpath;
using lamina::Path;
using lamina::PathRole;
using lamina::Point3;

constexpr double kRelative = 1e-12;  // what a multiplication and its inverse may round

void expectNear(const Point3& actual, const Point3& expected) {
  EXPECT_LE((actual - expected).norm(), kRelative * expected.norm());
}

/// A wall with a bead that varies, a retracted travel, a fill and a drop: everything a message can carry.
MachineToolpath machineToolpath() {
  Path wall;
  wall.role = PathRole::OuterWall;
  wall.is_closed = true;
  wall.points = {{0.1, 0.2, 0.3}, {10.7, 0.2, 0.3}, {10.7, 9.9, 0.3}};
  wall.bead = lamina::AlongPath<lamina::Bead>({{0.4, 0.3}, {0.41, 0.3}, {0.42, 0.31}});
  wall.feed_mm_s = 33.3;
  Path travel;
  travel.role = PathRole::Travel;
  travel.process.is_retracted = true;
  travel.points = {wall.lastPoint(), {1.0 / 3.0, 5.0, 0.5}};
  travel.feed_mm_s = 150.0;
  Path fill;
  fill.points = {travel.lastPoint(), {7.0, 5.0, 0.3}};
  fill.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Point3::UnitX()));
  fill.bead = lamina::Bead{0.4, 0.3};
  fill.feed_mm_s = 60.0;
  Path drop = fill;
  drop.deposit = lamina::Deposit::Drops;
  drop.points = {fill.lastPoint()};
  MachineToolpath placed;
  placed.toolpath.part_name = "wall";
  placed.toolpath.layers = {{0.3, 0.3, {wall, travel, fill, drop}}, {0.6, 0.3, {}}};
  placed.toolpath.part_from_layers = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Point3::UnitX()));
  placed.id = toolpathId(placed.toolpath);
  placed.machine = "gantry";
  placed.bed_from_part = Eigen::Translation3d(100.0, 90.0, 0.0) * Eigen::AngleAxisd(0.5, Point3::UnitZ());
  return placed;
}

TEST(Conversions, GiveMetresInMessages) {
  const auto point = lamina::toMessage(Point3(1.0, -20.0, 300.0));
  EXPECT_DOUBLE_EQ(point.x, 0.001);
  EXPECT_DOUBLE_EQ(point.y, -0.02);
  EXPECT_DOUBLE_EQ(point.z, 0.3);
  EXPECT_DOUBLE_EQ(lamina::toMessage(lamina::Bead{0.4, 0.2}).width, 0.0004);
  const auto message = lamina::toMessage(machineToolpath());
  EXPECT_DOUBLE_EQ(message.bed_from_part.position.x, 0.1);
  EXPECT_DOUBLE_EQ(message.layers.at(0).z, 0.0003);
  EXPECT_DOUBLE_EQ(message.layers.at(0).paths.at(1).feed.at(0), 0.15);
}

TEST(Conversions, GiveASummaryInMetres) {
  lamina::SliceSummary summary;
  summary.layers = 7;
  summary.mesh_volume_mm3 = 1000.0;
  summary.deposition_mm = 2500.0;
  summary.repairs = {"2 holes filled"};
  summary.lean.greatest_rad = 0.5;
  summary.lean.greatest_at = {10.0, 20.0, 30.0};
  summary.lean.overhang_mm = 0.2;
  summary.lean.beyond_bead_mm2 = 3e6;
  summary.refilling.runs = 4;
  summary.refilling.deposited_mm3 = 5e9;
  const auto message = lamina::toMessage(summary);
  EXPECT_EQ(message.layers, 7U);
  EXPECT_DOUBLE_EQ(message.mesh_volume, 1e-6);
  EXPECT_DOUBLE_EQ(message.deposition, 2.5);
  EXPECT_EQ(message.repairs, summary.repairs);
  EXPECT_DOUBLE_EQ(message.steepest_lean, 0.5);
  EXPECT_NEAR((lamina::fromMessage(message.steepest_lean_at) - Point3(10.0, 20.0, 30.0)).norm(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(message.overhang_per_layer, 2e-4);
  EXPECT_DOUBLE_EQ(message.beyond_bead, 3.0);
  EXPECT_EQ(message.refill_runs, 4U);
  EXPECT_DOUBLE_EQ(message.refilled_volume, 5.0);
}

TEST(Conversions, CarryAToolpathThereAndBack) {
  const MachineToolpath there = machineToolpath();
  const MachineToolpath back = lamina::fromMessage(lamina::toMessage(there));
  EXPECT_EQ(back.id, there.id);
  EXPECT_EQ(back.machine, there.machine);
  EXPECT_EQ(back.toolpath.part_name, there.toolpath.part_name);
  EXPECT_TRUE(back.bed_from_part.isApprox(there.bed_from_part, kRelative));
  EXPECT_EQ(back.toolpath.part_from_layers.coeffs(), there.toolpath.part_from_layers.coeffs());
  ASSERT_EQ(back.toolpath.layers.size(), there.toolpath.layers.size());
  ASSERT_EQ(back.toolpath.layers[0].paths.size(), there.toolpath.layers[0].paths.size());
  for (std::size_t p = 0; p < there.toolpath.layers[0].paths.size(); ++p) {
    const Path& expected = there.toolpath.layers[0].paths[p];
    const Path& actual = back.toolpath.layers[0].paths[p];
    EXPECT_EQ(actual.role, expected.role);
    EXPECT_EQ(actual.deposit, expected.deposit);
    EXPECT_EQ(actual.is_closed, expected.is_closed);
    EXPECT_EQ(actual.process.is_retracted, expected.process.is_retracted);
    EXPECT_EQ(actual.bead.values().size(), expected.bead.values().size());
    EXPECT_NEAR(actual.feed_mm_s.at(0), expected.feed_mm_s.at(0), kRelative * expected.feed_mm_s.at(0));
    EXPECT_TRUE(actual.orientation.at(0).isApprox(expected.orientation.at(0), kRelative));
    for (std::size_t i = 0; i < expected.points.size(); ++i) expectNear(actual.points[i], expected.points[i]);
  }
}

TEST(Conversions, CarryEventsToolsAndProcessValues) {
  using lamina::Dwell;
  using lamina::FanShare;
  using lamina::MachineCode;
  using lamina::OperatorPause;
  using lamina::PathRole;
  MachineToolpath there = machineToolpath();
  Path& path = there.toolpath.layers[0].paths[0];
  path.role = PathRole::SupportInterface;
  path.tool = 3;
  path.events = {
      {0, Dwell{1.5}}, {0, FanShare{0.25}}, {1, OperatorPause{"nuts"}}, {1, MachineCode{"M5", true}}};
  path.values = {{"power_w", 900.0}};
  path.events.push_back({2, lamina::PartMark{"lid 1"}});
  there.toolpath.events_at_end = {MachineCode{"M300", false}};
  const MachineToolpath back = lamina::fromMessage(lamina::toMessage(there));
  const Path& carried = back.toolpath.layers[0].paths[0];
  EXPECT_EQ(carried.role, PathRole::SupportInterface);
  EXPECT_EQ(carried.tool, 3U);
  ASSERT_EQ(carried.events.size(), 5U);
  EXPECT_EQ(std::get<lamina::PartMark>(carried.events[4].event).name, "lid 1");
  EXPECT_EQ(carried.events[2].motion, 1U);
  EXPECT_EQ(std::get<Dwell>(carried.events[0].event).duration_s, 1.5);
  EXPECT_EQ(std::get<FanShare>(carried.events[1].event).share, 0.25);
  EXPECT_EQ(std::get<OperatorPause>(carried.events[2].event).message, "nuts");
  EXPECT_EQ(std::get<MachineCode>(carried.events[3].event).text, "M5");
  EXPECT_TRUE(std::get<MachineCode>(carried.events[3].event).moves_axes);
  ASSERT_EQ(carried.values.size(), 1U);
  EXPECT_EQ(carried.values[0].name, "power_w");
  EXPECT_EQ(carried.values[0].value.at(0), 900.0);
  ASSERT_EQ(back.toolpath.events_at_end.size(), 1U);
  EXPECT_FALSE(std::get<MachineCode>(back.toolpath.events_at_end[0]).moves_axes);
  auto message = lamina::toMessage(there);
  message.layers[0].paths[0].events[0].kind = 9;
  EXPECT_THROW(lamina::fromMessage(message), lamina::InvalidInput);
  message = lamina::toMessage(there);
  message.layers[0].paths[0].role = 16;
  EXPECT_THROW(lamina::fromMessage(message), lamina::InvalidInput);
}

TEST(Conversions, CarryAnyPointThereAndBack) {
  EXPECT_TRUE(rc::check("a point survives the way through metres", [] {
    const auto coordinate = [] { return *rc::gen::inRange(-2000000, 2000000) / 997.0; };
    const Point3 point(coordinate(), coordinate(), coordinate());
    RC_ASSERT((lamina::fromMessage(lamina::toMessage(point)) - point).norm() <= kRelative * point.norm());
  }));
}

TEST(Conversions, LeaveOutWhatASensorSendsInPlaceOfPoints) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Isometry3d bed_from_sensor(Eigen::Translation3d(10.0, 20.0, 60.0) *
                                          Eigen::AngleAxisd(M_PI, Point3::UnitX()));
  const auto cloud = lamina::toCloudMessage(
      {Point3(0, 0, 0), Point3(1, 0, 59), Point3(kNone, 0, 60), Point3(-0.0, 0, 0), Point3(0, 0, 58)});
  const lamina::CloudPoints read = lamina::fromMessage(cloud, bed_from_sensor);
  EXPECT_EQ(read.not_finite, 3u);
  ASSERT_EQ(read.points.size(), 2u);
  EXPECT_LT((read.points[0] - Point3(11, 20, 1)).norm(), 1e-4);  // single precision of metres
  EXPECT_LT((read.points[1] - Point3(10, 20, 2)).norm(), 1e-4);
}

sensor_msgs::PointField fieldOf(const std::string& name, std::uint8_t type, std::uint32_t offset) {
  sensor_msgs::PointField field;
  field.name = name;
  field.datatype = type;
  field.offset = offset;
  field.count = 1;
  return field;
}

/// A point at 1.5, -2 and 0.0625 m: x and y as double, z as float, with the highest byte first.
sensor_msgs::PointCloud2 cloudOfDoubles() {
  using Field = sensor_msgs::PointField;
  sensor_msgs::PointCloud2 cloud;
  cloud.fields = {fieldOf("y", Field::FLOAT64, 0), fieldOf("x", Field::FLOAT64, 8),
                  fieldOf("z", Field::FLOAT32, 16)};
  cloud.data = {0xC0, 0, 0, 0, 0, 0, 0, 0, 0x3F, 0xF8, 0, 0, 0, 0, 0, 0, 0x3D, 0x80, 0, 0};
  cloud.is_bigendian = 1;
  cloud.point_step = cloud.row_step = 20;
  cloud.width = cloud.height = 1;
  return cloud;
}

TEST(Conversions, ReadCloudsOfDoublesInEitherOrderOfBytes) {
  const Point3 expected(1500.0, -2000.0, 62.5);
  sensor_msgs::PointCloud2 cloud = cloudOfDoubles();
  EXPECT_EQ(lamina::profilesFromMessage(cloud), (std::vector<std::vector<Point3>>{{expected}}));
  std::reverse(cloud.data.begin(), cloud.data.begin() + 8);
  std::reverse(cloud.data.begin() + 8, cloud.data.begin() + 16);
  std::reverse(cloud.data.begin() + 16, cloud.data.end());
  cloud.is_bigendian = 0;
  const lamina::CloudPoints read = lamina::fromMessage(cloud, Eigen::Isometry3d::Identity());
  ASSERT_EQ(read.points.size(), 1u);
  EXPECT_EQ(read.points[0], expected);
}

TEST(Conversions, RefuseCloudsOfOtherNumbersOrTooFewBytes) {
  sensor_msgs::PointCloud2 cloud = cloudOfDoubles();
  cloud.fields[1].datatype = sensor_msgs::PointField::INT32;
  EXPECT_THROW(lamina::profilesFromMessage(cloud), lamina::InvalidInput);
  cloud = cloudOfDoubles();
  cloud.fields[2].datatype = sensor_msgs::PointField::FLOAT64;  // which ends beyond the point
  EXPECT_THROW(lamina::profilesFromMessage(cloud), lamina::InvalidInput);
}

/// 1.8e308 m have no number in millimetres.
TEST(Conversions, LeaveOutDoublesThatOverflow) {
  sensor_msgs::PointCloud2 cloud = cloudOfDoubles();
  cloud.data[0] = 0x7F;
  cloud.data[1] = 0xEF;
  const lamina::CloudPoints read = lamina::fromMessage(cloud, Eigen::Isometry3d::Identity());
  EXPECT_EQ(read.points.size(), 0u);
  EXPECT_EQ(read.not_finite, 1u);
}

TEST(Conversions, RefuseAToolpathThatBreaksItsPromises) {
  const auto good = lamina::toMessage(machineToolpath());
  auto not_finite = good;
  not_finite.layers[0].paths[0].points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(lamina::fromMessage(not_finite), lamina::InvalidInput);
  auto gap = good;
  gap.layers[0].paths.erase(gap.layers[0].paths.begin() + 1);
  EXPECT_THROW(lamina::fromMessage(gap), lamina::InvalidInput);
  auto no_feed = good;
  no_feed.layers[0].paths[0].feed.clear();
  EXPECT_THROW(lamina::fromMessage(no_feed), lamina::InvalidInput);
  auto unknown_role = good;
  unknown_role.layers[0].paths[0].role = 77;
  EXPECT_THROW(lamina::fromMessage(unknown_role), lamina::InvalidInput);
  auto unknown_deposit = good;
  unknown_deposit.layers[0].paths[0].deposit = 2;
  EXPECT_THROW(lamina::fromMessage(unknown_deposit), lamina::InvalidInput);
  auto no_pose = good;
  no_pose.bed_from_part.orientation.w = 9.0;
  EXPECT_THROW(lamina::fromMessage(no_pose), lamina::InvalidInput);
}

}  // namespace
