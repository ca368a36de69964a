// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/sensor_recording.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "recorded_cell.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::string refusalOf(const std::string& text) {
  try {
    posesFromCsv(text, "poses.csv");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(SensorRecording, ReadsBackWhatWasWritten) {
  const test::ScratchFolder folder;
  const SensorRecording recording = test::record({}, test::LinearMotion({75, 0, 2}, {{{75, 5, 3}, 10.0}}));
  writeRecording(folder.file("."), recording);
  const SensorRecording read = readRecording(folder.file("."));
  ASSERT_EQ(read.poses.size(), recording.poses.size());
  ASSERT_EQ(read.profiles.size(), recording.profiles.size());
  for (std::size_t i = 0; i < read.poses.size(); ++i) {
    EXPECT_EQ(read.poses[i].time_s, recording.poses[i].time_s);
    EXPECT_LT((read.poses[i].bed_from_nozzle.matrix() - recording.poses[i].bed_from_nozzle.matrix()).norm(),
              1e-12);
  }
  for (std::size_t i = 0; i < read.profiles.size(); ++i)
    EXPECT_EQ(read.profiles[i].points, recording.profiles[i].points);
}

TEST(SensorRecording, OfAnUprightNozzleNeedsNoTurn) {
  const auto poses = posesFromCsv("x_mm, y_mm,z_mm,time_s\n# remark\n1,2,3,11\n4,5,6,10\n", "poses.csv");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].time_s, 10.0);
  EXPECT_EQ(poses[1].bed_from_nozzle.translation(), Point3(1, 2, 3));
  EXPECT_LT((poses[1].bed_from_nozzle.linear() * Point3::UnitZ() + Point3::UnitZ()).norm(), 1e-12);
}

TEST(SensorRecording, HasNoPointsWhereSensorsSendZeros) {
  const auto profiles =
      profilesFromCsv("time_s,x_mm,z_mm\n1,0,0\n1,0,60\n1,-0,0.0\n2,0,0\n3,5,0\n3,0,0\n", "profiles.csv");
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].points, std::vector<Point3>({Point3(0, 0, 60)}));
  EXPECT_EQ(profiles[1].time_s, 3.0);
  EXPECT_EQ(profiles[1].points, std::vector<Point3>({Point3(5, 0, 0)}));
  EXPECT_THROW(profilesFromCsv("time_s,x_mm,z_mm\n1,0,0\n", "profiles.csv"), InvalidInput);
}

TEST(SensorRecording, IsRefusedByName) {
  EXPECT_NE(refusalOf("time_s,x_mm,y_mm,z_mm\n1,2,3,4\n2,3,4\n").find("line 3"), std::string::npos);
  EXPECT_NE(refusalOf("time_s,x_mm,y_mm,z_mm\n1,2,nan,4\n").find("cell 3"), std::string::npos);
  EXPECT_NE(refusalOf("time_s,x_mm,y_mm\n").find("z_mm"), std::string::npos);
  EXPECT_NE(refusalOf("time_s,x_mm,y_mm,z_mm\n1,2,3,4\n").find("at least 2"), std::string::npos);
  EXPECT_NE(refusalOf("time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,2,3,4,1,1,0,0\n").find("quaternion"),
            std::string::npos);
  EXPECT_NE(refusalOf("").find("no header"), std::string::npos);
  EXPECT_NE(refusalOf("a,a\n").find("same name"), std::string::npos);
  EXPECT_THROW(profilesFromCsv("time_s,x_mm,z_mm\n", "profiles.csv"), InvalidInput);
  EXPECT_THROW(readRecording("/nowhere"), FileError);
}

TEST(SensorRecording, PosesGoStraightBetweenStamps) {
  const std::vector<RecordedPose> poses = {{1.0, test::nozzleAt({0, 0, 0})},
                                           {2.0, test::nozzleAt({10, 0, 2})}};
  EXPECT_LT((poseAt(poses, 1.25)->translation() - Point3(2.5, 0.0, 0.5)).norm(), 1e-12);
  EXPECT_EQ(poseAt(poses, 2.0)->translation(), Point3(10, 0, 2));
  EXPECT_FALSE(poseAt(poses, 0.999));
  EXPECT_FALSE(poseAt(poses, 2.001));
  EXPECT_FALSE(poseAt({}, 1.0));
}

TEST(SensorRecording, OfAnyTextIsReadOrRefused) {
  EXPECT_TRUE(rc::check("cells of any kind", [] {
    std::string text = *rc::gen::element<std::string>("time_s,x_mm,y_mm,z_mm\n", "time_s,x_mm,z_mm\n", "");
    const auto cells = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
        "1", "-2.5", "1e300", "nan", "", ",", ",", ",", "\n", "\n", "#", "\"", "x"));
    for (const std::string& cell : cells) text += cell;
    try {
      posesFromCsv(text, "any");
    } catch (const InvalidInput&) {
    }
    try {
      profilesFromCsv(text, "any");
    } catch (const InvalidInput&) {
    }
  }));
}

}  // namespace
}  // namespace lamina
