// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Methods of `lamina calibrate` that no program of `calibrate plan` serves, from bags.
#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include "calibration/recorded_cell.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kBagLate = 0.08;  // s, of the sensor
constexpr double kDegree = M_PI / 180.0;

/// About 3 mm and 2 deg off where its description says.
Eigen::Isometry3d movedSensor() {
  Eigen::Isometry3d pose = test::nominalSensor();
  pose.translation() += Point3(2.0, -1.5, 1.5);
  pose.linear() = Eigen::AngleAxisd(2.0 * kDegree, Point3(0.5, -0.6, 0.7).normalized()).toRotationMatrix() *
                  pose.linear();
  return pose;
}

test::RecordedCell lateCell() {
  test::RecordedCell cell;
  cell.offset_s = kBagLate;
  cell.noise_mm = 0.02;
  return cell;
}

/// As a recorder has it: transforms and clouds by their stamps.
void writeRecordedBag(const std::string& path, const SensorRecording& recording) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::LZ4);
  for (const RecordedPose& pose : recording.poses) {
    tf2_msgs::TFMessage message;
    message.transforms = {
        test::stamped(pose.bed_from_nozzle, names::kBedFrame, names::kNozzleFrame, ros::Time(pose.time_s))};
    bag.write("/tf", ros::Time(pose.time_s), message);
  }
  for (const RecordedProfile& profile : recording.profiles) {
    sensor_msgs::PointCloud2 message = toCloudMessage(profile.points);
    message.header.frame_id = names::kSensorFrame;
    message.header.stamp = ros::Time(profile.time_s);
    bag.write(names::kProfile, message.header.stamp, message);
  }
}

void calibrate(const std::string& arguments, const std::string& cell) {
  const std::string command =
      std::string(LAMINA_COMMAND) + " calibrate " + arguments + " --machine cartesian_gantry -o " + cell;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

/// A head that tilts about x and y over a place, at three heights.
Eigen::Isometry3d headThatTilts(double time_s) {
  const int step = std::min(14, static_cast<int>(time_s / 0.5));
  const double tilts[5][2] = {{0, 0}, {18, 0}, {-18, 0}, {0, 18}, {0, -18}};
  const double* const tilt = tilts[step % 5];
  const int height = step / 5;
  return test::nozzleAt({100.0, 100.0, 5.0 + 7.0 * height}) *
         Eigen::AngleAxisd(tilt[0] * kDegree, Point3::UnitX()) *
         Eigen::AngleAxisd(tilt[1] * kDegree, Point3::UnitY());
}

void expectPlace(const std::string& cell, const char* method) {
  const Calibration found = readCalibration(cell);
  ASSERT_TRUE(found.pose) << method;
  EXPECT_EQ(found.pose->origin.method, method);
  EXPECT_EQ(found.pose->not_found, "") << method;
  const Eigen::Isometry3d off = found.pose->nozzle_from_sensor.inverse() * movedSensor();
  EXPECT_LT(off.translation().norm(), 0.05) << method;
  EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 0.05 * kDegree) << method;
}

TEST(CalibrationTest, FindsTheTimeOffsetByAnEdgeFromABag) {
  const test::ScratchFolder folder;
  test::RecordedCell cell = lateCell();
  cell.surface = [](const Point2& at) { return at.y() + 0.2 * (at.x() - 100.0) > 0.0 ? 0.5 : 0.0; };
  std::vector<test::LinearMotion::Way> ways;
  for (int i = 0; i < 8; ++i) ways.push_back({{75.0, i % 2 == 0 ? 20.0 : -20.0, 2.0}, 20.0});
  writeRecordedBag(folder.file("edge.bag"), test::record(cell, {{75.0, -20.0, 2.0}, ways}));
  calibrate("time " + folder.file("edge.bag") + " --method edge", folder.file("cell.yaml"));
  const Calibration found = readCalibration(folder.file("cell.yaml"));
  ASSERT_TRUE(found.time);
  EXPECT_EQ(found.time->origin.method, "edge");
  EXPECT_NEAR(found.time->offset_s, kBagLate, 0.001);
}

TEST(CalibrationTest, FindsWhereTheSensorSitsByTheBedFromABag) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("cell.yaml");
  Calibration known;
  known.machine = "cartesian_gantry";
  known.time = CalibratedTime{kBagLate, 1e-4, 0.0, 0.0, {"edge", "2026-11-23T12:00:00Z"}};
  test::RecordedCell cell = lateCell();
  cell.nozzle_from_sensor = movedSensor();
  writeCalibration(path, known);
  writeRecordedBag(folder.file("bed.bag"), test::record(cell, headThatTilts, 7.4));
  calibrate("sensor " + folder.file("bed.bag") + " --method bed", path);
  expectPlace(path, "bed");
}

}  // namespace
}  // namespace lamina
