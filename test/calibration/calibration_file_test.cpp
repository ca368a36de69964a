// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/calibration_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

Calibration whole() {
  Calibration cell{"cartesian_gantry", "profiler 12", {}, {}, {}};
  cell.time = CalibratedTime{0.08125, 1.25e-4, 3e-4, -1e-6, {"bobbing", "2026-11-23T12:00:00Z"}};
  CalibratedPose pose;
  pose.nozzle_from_sensor.translation() = Eigen::Vector3d(25.1, -0.2, -60.03);
  pose.nozzle_from_sensor.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -2, 3).normalized()));
  pose.spread = {0.01, 0.02, 0.0, 0.01, 0.0, 0.03};
  pose.not_found = "z, turn about y";
  pose.origin = {"cross", "2026-11-23T12:30:00Z"};
  cell.pose = pose;
  cell.feeder = CalibratedFeeder{0.6, 0.01, 0.3, 0.02, {"bead", "2026-11-23T13:00:00Z"}};
  return cell;
}

std::string refusal(const std::string& yaml) {
  try {
    calibrationFromYaml(yaml, "cell.yaml");
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

std::string without(std::string yaml, const std::string& key) {
  const std::size_t at = yaml.find(key);
  EXPECT_NE(at, std::string::npos) << key;
  return yaml.erase(at, yaml.find('\n', at) + 1 - at);
}

TEST(CalibrationFile, ReadsBackWhatWasWritten) {
  const test::ScratchFolder folder;
  const Calibration cell = whole();
  writeCalibration(folder.file("cell.yaml"), cell);
  const Calibration read = readCalibration(folder.file("cell.yaml"));
  EXPECT_EQ(read.machine, cell.machine);
  EXPECT_EQ(read.sensor, cell.sensor);
  ASSERT_TRUE(read.time && read.pose && read.feeder);
  EXPECT_EQ(read.time->offset_s, 0.08125);
  EXPECT_EQ(read.time->drift_s_per_min, -1e-6);
  EXPECT_EQ(read.time->origin.date, "2026-11-23T12:00:00Z");
  EXPECT_LT((read.pose->nozzle_from_sensor.matrix() - cell.pose->nozzle_from_sensor.matrix()).norm(), 1e-12);
  EXPECT_EQ(read.pose->spread, cell.pose->spread);
  EXPECT_EQ(read.pose->not_found, "z, turn about y");
  EXPECT_EQ(read.feeder->lag_s, 0.3);
  EXPECT_EQ(toYaml(read).size(), toYaml(cell).size());
}

TEST(CalibrationFile, HoldsPartsThatWereFoundAlone) {
  Calibration cell = whole();
  cell.pose.reset();
  cell.feeder.reset();
  EXPECT_EQ(toYaml(cell).find("pose"), std::string::npos);
  const Calibration read = calibrationFromYaml(toYaml(cell), "cell.yaml");
  EXPECT_TRUE(read.time && !read.pose && !read.feeder);
}

TEST(CalibrationFile, IsReadStrictly) {
  const std::string yaml = toYaml(whole());
  EXPECT_EQ(refusal(yaml), "");
  EXPECT_NE(refusal(without(yaml, "  machine:")).find("names no machine"), std::string::npos);
  EXPECT_NE(refusal(without(yaml, "  time_offset_spread_s:")).find("time_offset_spread_s"),
            std::string::npos);
  EXPECT_NE(refusal(without(yaml, "  pose_rpy_deg:")).find("pose_rpy_deg"), std::string::npos);
  EXPECT_NE(refusal(yaml + "  lag: 1\n").find("feeder.lag"), std::string::npos);
  std::string typed = yaml;
  typed.replace(typed.find("0.08125"), 7, "1e9    ");
  EXPECT_NE(refusal(typed).find("time_offset_s"), std::string::npos);
  typed = yaml;
  typed.replace(typed.find("bobbing"), 7, "\"\"     ");
  EXPECT_NE(refusal(typed).find("method or date"), std::string::npos);
}

TEST(CalibrationFile, IsOfOneMachine) {
  EXPECT_NO_THROW(requireCalibrationOf(whole(), "cartesian_gantry"));
  EXPECT_THROW(requireCalibrationOf(whole(), "irb_4600"), InvalidConfig);
}

TEST(CalibrationFile, KeepsAnyTurn) {
  EXPECT_TRUE(rc::check("roll, pitch and yaw and back", [] {
    const auto angle = [] {
      return *rc::gen::element(0.0, 0.3, 1.57079632679489662, -2.0, 3.1, -1.57079632679489662);
    };
    Calibration cell = whole();
    cell.pose->nozzle_from_sensor.linear() = (Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitZ()) *
                                              Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitY()) *
                                              Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitX()))
                                                 .toRotationMatrix();
    const Calibration read = calibrationFromYaml(toYaml(cell), "cell.yaml");
    RC_ASSERT((read.pose->nozzle_from_sensor.matrix() - cell.pose->nozzle_from_sensor.matrix()).norm() <
              1e-9);
  }));
}

}  // namespace
}  // namespace lamina
