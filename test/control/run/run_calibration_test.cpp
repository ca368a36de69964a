// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/run_calibration.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

bool says(const std::vector<std::string>& sentences, std::size_t which, const std::string& words) {
  return sentences.at(which).find(words) != std::string::npos;
}

/// A sensor 60 mm above the tip; turns about x and y known to 0.3 and 0.4 mrad, so 0.03 mm off at the tip.
Calibration found() {
  Calibration calibration;
  calibration.machine = "gantry";
  calibration.time = CalibratedTime{0.08, 0.002, 0.001, 0.0, {"bobbing", "2026-11-23T12:00:00Z"}};
  CalibratedPose pose;
  pose.nozzle_from_sensor.translation() = Point3(25.0, -1.5, -60.0);
  const double degrees = 180.0 / M_PI;
  pose.spread = {0.06, 0.02, 0.007, 3e-4 * degrees, 4e-4 * degrees, 0.0};
  pose.not_found = "z";
  pose.origin = {"cross", "2026-11-23T12:00:01Z"};
  calibration.pose = pose;
  calibration.feeder = CalibratedFeeder{0.5, 0.03, 0.2, 0.04, {"bead", "2026-11-23T12:00:02Z"}};
  return calibration;
}

LoopRunSettings named(const std::string& file) {
  LoopRunSettings settings;
  settings.calibration.file = file;
  return settings;
}

TEST(RunCalibration, FillsWhatIsNotStated) {
  const LoopRunSettings settings = withCalibration(named("cell.yaml"), found());
  const CellCalibration& known = settings.calibration;
  EXPECT_DOUBLE_EQ(known.time_offset_s, 0.08);
  EXPECT_TRUE(known.is_time_offset_trusted);
  EXPECT_DOUBLE_EQ(known.time_offset_sigma_s, 0.002);
  ASSERT_TRUE(known.nozzle_from_sensor);
  EXPECT_TRUE(known.nozzle_from_sensor->isApprox(found().pose->nozzle_from_sensor));
  EXPECT_TRUE(known.is_place_trusted);
  EXPECT_NEAR(known.place_error_mm, 0.07, 1e-12) << "of 0.06, 0.02 and 60 mm times 0.5 mrad";
  EXPECT_DOUBLE_EQ(settings.sight.pose_sigma_mm, 0.007);
  EXPECT_DOUBLE_EQ(settings.loop.dead_time_s, 0.5);
  EXPECT_DOUBLE_EQ(settings.loop.lag_s, 0.2);
  EXPECT_DOUBLE_EQ(known.feeder_uncertainty_s, 0.05) << "3, 4, 5";
  EXPECT_EQ(known.machine, "gantry");
  ASSERT_EQ(known.sources.size(), 3U);
  for (const char* words : {"80.000 ms", "2.000 ms", "bobbing", "2026-11-23T12:00:00Z", "cell.yaml"})
    EXPECT_TRUE(says(known.sources, 0, words)) << words;
  for (const char* words : {"25.000, -1.500, -60.000 mm", "0.070 mm", "cross", "z not found"})
    EXPECT_TRUE(says(known.sources, 1, words)) << words;
  for (const char* words : {"500.000 ms", "200.000 ms", "50.000 ms", "bead"})
    EXPECT_TRUE(says(known.sources, 2, words)) << words;
}

TEST(RunCalibration, WhatIsStatedWinsAndIsSaidToDoSo) {
  LoopRunSettings stated = named("cell.yaml");
  stated.calibration.time_offset_s = 0.03;
  stated.calibration.is_time_offset_trusted = true;
  stated.calibration.is_place_trusted = true;
  stated.calibration.place_error_mm = 0.5;
  stated.loop.lag_s = 0.7;
  const LoopRunSettings settings = withCalibration(stated, found());
  const CellCalibration& known = settings.calibration;
  EXPECT_DOUBLE_EQ(known.time_offset_s, 0.03);
  EXPECT_DOUBLE_EQ(known.time_offset_sigma_s, 0.0);
  EXPECT_FALSE(known.nozzle_from_sensor) << "tf says where it sits";
  EXPECT_DOUBLE_EQ(known.place_error_mm, 0.5);
  EXPECT_DOUBLE_EQ(settings.loop.dead_time_s, 0.0);
  EXPECT_DOUBLE_EQ(settings.loop.lag_s, 0.7);
  EXPECT_TRUE(says(known.sources, 0, "30.000 ms as stated; not the 80.000 ms found by bobbing"));
  EXPECT_TRUE(says(known.sources, 1, "as stated; not the one found by cross"));
  EXPECT_TRUE(says(known.sources, 2, "as stated; not the dead time 500.000 ms"));
}

TEST(RunCalibration, ASpreadThatIsStatedWinsBesideAnOffsetThatIsNot) {
  LoopRunSettings stated = named("cell.yaml");
  stated.calibration.time_offset_sigma_s = 0.01;
  EXPECT_DOUBLE_EQ(withCalibration(stated, found()).calibration.time_offset_sigma_s, 0.01);
}

TEST(RunCalibration, DoesNotTrustAPoseThatDoesNotSayWhereOnTheBedTheSensorSees) {
  for (const char* missed : {"x, y, turn about z", "y", "x"}) {
    Calibration calibration = found();
    calibration.pose->not_found = missed;
    const LoopRunSettings settings = withCalibration(named("cell.yaml"), calibration);
    EXPECT_FALSE(settings.calibration.is_place_trusted) << missed;
    EXPECT_TRUE(says(settings.calibration.sources, 1, "expected x and y to be found")) << missed;
  }
  Calibration tilts = found();
  tilts.pose->not_found = "turn about x, turn about y";
  EXPECT_TRUE(withCalibration(named("cell.yaml"), tilts).calibration.is_place_trusted);
}

TEST(RunCalibration, KnowsNothingWithoutEither) {
  const LoopRunSettings settings = withCalibrationFile(named(""));
  EXPECT_FALSE(settings.calibration.is_time_offset_trusted);
  EXPECT_FALSE(settings.calibration.is_place_trusted);
  EXPECT_TRUE(says(settings.calibration.sources, 0, "not known"));
  EXPECT_TRUE(says(settings.calibration.sources, 1, "not known"));
  const test::SensedWall wall = test::sensedWall({settings});
  EXPECT_EQ(wall.status.state, LoopState::Off);
}

TEST(RunCalibration, ReadsTheFileThatTheSettingsName) {
  const test::ScratchFolder folder;
  writeCalibration(folder.file("cell.yaml"), found());
  EXPECT_DOUBLE_EQ(withCalibrationFile(named(folder.file("cell.yaml"))).calibration.time_offset_s, 0.08);
  EXPECT_THROW(withCalibrationFile(named(folder.file("none.yaml"))), FileError);
}

TEST(RunCalibration, RefusesWhatNoSettingMayBe) {
  Calibration calibration = found();
  calibration.time->offset_s = 61.0;
  try {
    withCalibration(named("cell.yaml"), calibration);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("sensor.time_offset_s"), std::string::npos) << error.what();
  }
}

LoopStatus statusOn(const std::string& machine, const LoopRunSettings& settings) {
  test::SensedWallCase wall;
  wall.layers = 2;
  return LoopRun({"id", Eigen::Isometry3d::Identity(), test::scannedWall(wall), machine}, settings).status();
}

TEST(RunCalibration, LetsTheLoopStartOnItsOwnMachineAlone) {
  LoopRunSettings settings = named("cell.yaml");
  settings.request = LoopRequest::Active;
  EXPECT_EQ(statusOn("gantry", settings).state, LoopState::Blocked);
  settings = withCalibration(settings, found());
  EXPECT_EQ(statusOn("gantry", settings).state, LoopState::Active);
  const LoopStatus other = statusOn("belt", settings);
  EXPECT_EQ(other.state, LoopState::Blocked);
  EXPECT_EQ(other.reason,
            "the calibration 'cell.yaml' is that of machine 'gantry'; expected that of 'belt', which the "
            "toolpath is for");
}

TEST(RunCalibration, OfAPrintUnderWayLetsItsLoopBegin) {
  LoopRunSettings settings = named("cell.yaml");
  settings.loop.narrow_low_pass = NarrowLowPass::Raised;
  test::SensedWallCase wall;
  wall.layers = 2;
  LoopRun run({"id", Eigen::Isometry3d::Identity(), test::scannedWall(wall), "gantry"}, settings);
  CellCalibration known = withCalibration(settings, found()).calibration;
  run.recalibrate(known, LoopRequest::Active);
  EXPECT_EQ(run.status().state, LoopState::Off) << "as the operator has it";
  run.request(LoopRequest::Active);
  EXPECT_EQ(run.status().state, LoopState::Active);
  known.machine = "belt";
  run.recalibrate(known, LoopRequest::Active);
  EXPECT_EQ(run.status().state, LoopState::Blocked);
  known.machine = "gantry";
  run.recalibrate(known, LoopRequest::Identify);
  EXPECT_EQ(run.status().state, LoopState::Identifying);
  known.time_offset_sigma_s = 0.2;  // 4 mm at 20 mm/s: the low-pass of 3 mm would be raised
  run.recalibrate(known, LoopRequest::Active);
  EXPECT_EQ(run.status().state, LoopState::Blocked);
  EXPECT_NE(run.status().reason.find("next one"), std::string::npos) << run.status().reason;
}

TEST(FeederCalibration, LeadsAnExecutorUnlessItsDelayIsStated) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("cell.yaml");
  Calibration cell;
  cell.machine = "gantry";
  cell.feeder = CalibratedFeeder{0.6, 0.01, 0.2, 0.02, {"bead", "2026-11-23T12:00:00Z"}};
  writeCalibration(file, cell);
  const CalibratedFeeding found = withFeederOf(file, {}, "gantry");
  EXPECT_EQ(found.loop.dead_time_s, 0.6);
  EXPECT_EQ(found.loop.lag_s, 0.2);
  EXPECT_NE(found.source.find("600.000 ms"), std::string::npos) << found.source;
  LoopSettings stated;
  stated.lag_s = 0.1;
  EXPECT_EQ(withFeederOf(file, stated, "gantry").loop.dead_time_s, 0.0);
  EXPECT_EQ(withFeederOf(file, stated, "gantry").loop.lag_s, 0.1);
  EXPECT_EQ(withFeederOf("", stated, "gantry").loop.lag_s, 0.1);
  EXPECT_THROW(withFeederOf(folder.file("none.yaml"), {}, "gantry"), FileError);
  try {
    withFeederOf(file, {}, "robot");
    FAIL() << "the calibration of another machine";
  } catch (const InvalidConfig& error) {
    const std::string said = error.what();
    for (const char* word : {"cell.yaml", "gantry", "robot"})
      EXPECT_NE(said.find(word), std::string::npos) << word << " in: " << said;
  }
}

}  // namespace
}  // namespace lamina
