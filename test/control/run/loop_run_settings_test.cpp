// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_run_settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

LoopRunSettings settingsWith(const std::vector<SettingText>& texts) {
  LoopRunSettings settings = test::calibratedLoop();
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& text : texts) schema.set(text.key, text.text);
  return settings;
}

Toolpath twoLayers() {
  test::SensedWallCase wall;
  wall.layers = 2;
  return test::scannedWall(wall);
}

TEST(RunSettings, StateTheTimeOffsetsOfFurtherSensors) {
  const LoopRunSettings settings = settingsWith({{"sensor.other_time_offsets_s", "{left: 0.07, right: -1}"}});
  const std::map<std::string, double> expected = {{"left", 0.07}, {"right", -1.0}};
  EXPECT_EQ(otherTimeOffsets(settings.calibration.other_time_offsets_s), expected);
  const LoopRunSettings wrong = settingsWith({{"sensor.other_time_offsets_s", "{left: 61}"}});
  EXPECT_THROW(otherTimeOffsets(wrong.calibration.other_time_offsets_s), InvalidConfig);
}

/// It was taken, and no layer waited for it.
TEST(RunSettings, TakeNoTemperatureThatNothingWaitsFor) {
  EXPECT_THROW(settingsWith({{"loop.interpass_c", "150"}}), InvalidConfig);
}

/// The loop goes by the worst of them where it does not know which one sees.
TEST(RunSettings, StateHowWellTheTimeOffsetOfEachSensorIsKnown) {
  const LoopRunSettings settings =
      settingsWith({{"sensor.time_offset_sigma_s", "0.03"},
                    {"feeder.uncertainty_s", "0.12"},
                    {"sensor.other_time_offset_sigmas_s", "{left: 0.05, right: 0}"}});
  const TimeOffsetSigmas sigmas = timeOffsetSigmas(settings.calibration);
  EXPECT_EQ(sigmas.of("left"), 0.05);
  EXPECT_EQ(sigmas.of("/right"), 0.0);
  EXPECT_EQ(sigmas.of("sensor"), 0.03);
  EXPECT_DOUBLE_EQ(calibrationFor(twoLayers(), settings).delay_uncertainty_s, 0.13) << "5, 12, 13";
  const LoopRunSettings wrong = settingsWith({{"sensor.other_time_offset_sigmas_s", "{left: -0.1}"}});
  EXPECT_THROW(timeOffsetSigmas(wrong.calibration), InvalidConfig);
}

TEST(RunSettings, SayHowWellEverythingIsKnown) {
  const LoopCalibration known =
      calibrationFor(twoLayers(), settingsWith({{"sensor.time_offset_sigma_s", "0.3"},
                                                {"feeder.uncertainty_s", "0.4"},
                                                {"sensor.place_error_mm", "0.7"},
                                                {"process.levelling_mm", "1.1"},
                                                {"process.standoff", "0.2"},
                                                {"process.gain_ratio", "1.3"},
                                                {"monitor.cell_mm", "0.25"}}));
  EXPECT_DOUBLE_EQ(known.speed_mm_s, 20.0) << "of beads, not of travels";
  EXPECT_DOUBLE_EQ(known.bead_width_mm, 3.0);
  EXPECT_DOUBLE_EQ(known.delay_uncertainty_s, 0.5) << "3, 4, 5";
  EXPECT_DOUBLE_EQ(known.place_error_mm, 0.7);
  EXPECT_DOUBLE_EQ(known.levelling_mm, 1.1);
  EXPECT_DOUBLE_EQ(known.standoff, 0.2);
  EXPECT_DOUBLE_EQ(known.gain_ratio, 1.3);
  EXPECT_DOUBLE_EQ(known.cell_mm, 0.25);
  EXPECT_TRUE(known.has_time_offset);
  EXPECT_TRUE(known.has_sensor_place);
}

LoopStatus statusWith(const std::vector<SettingText>& texts) {
  return LoopRun({"id", Eigen::Isometry3d::Identity(), twoLayers()}, settingsWith(texts)).status();
}

TEST(RunSettings, BlockWhatIsNotCalibratedWellEnough) {
  EXPECT_EQ(statusWith({}).state, LoopState::Active);
  EXPECT_EQ(statusWith({{"request", "identify"}}).state, LoopState::Identifying);
  EXPECT_EQ(statusWith({{"request", "none"}}).state, LoopState::Off);
  EXPECT_EQ(statusWith({{"sensor.time_offset_trusted", "false"}}).state, LoopState::Blocked);
  EXPECT_EQ(statusWith({{"sensor.place_trusted", "false"}}).state, LoopState::Blocked);
  // 20 mm/s times 0.2 s are 4 mm; the low-pass of 3 mm is less than one and a half of that.
  EXPECT_EQ(statusWith({{"sensor.time_offset_sigma_s", "0.2"}}).state, LoopState::Blocked);
  EXPECT_EQ(statusWith({{"sensor.time_offset_sigma_s", "0.2"}, {"loop.narrow_low_pass", "raised"}}).state,
            LoopState::Active);
  EXPECT_EQ(statusWith({{"process.gain_ratio", "4.1"}}).state, LoopState::Blocked) << "half of it is above 2";
}

/// Readings of a cloud that was taken 8 mm behind the nozzle on the first layer.
std::uint64_t readBehind(const std::vector<SettingText>& texts) {
  LoopRun run({"id", Eigen::Isometry3d::Identity(), twoLayers()}, settingsWith(texts));
  for (int i = 0; i <= 20; ++i) run.observe({1'000'000'000 + i * 100'000'000LL, {1.0 * i, 0.0, 1.5}});
  SensedCloud cloud;
  cloud.stamp_ns = 3'000'000'000;
  cloud.bed_from_sensor = test::sensorOver({12.0, 0.0, 1.5});
  cloud.profiles.emplace_back();
  for (int i = -10; i <= 10; ++i) cloud.profiles[0].emplace_back(0.1 * i, 0.0, 60.0);
  run.see(cloud);
  run.passAll();
  return run.counts().readings_used;
}

TEST(RunSettings, CellsAreReadOnceTheNozzleHasLeftThemBehind) {
  EXPECT_EQ(readBehind({}), 1U) << "a bead's width of 3 mm";
  EXPECT_EQ(readBehind({{"monitor.settle_mm", "7"}}), 1U);
  EXPECT_EQ(readBehind({{"monitor.settle_mm", "9"}}), 0U);
}

/// The nozzle goes at 10 mm/s: 20 mm along now, it left what lies at 12 mm behind by a bead's width of 3 mm
/// 0.5 s ago, or up to a cell later.
TEST(RunSettings, CellsAreReadOnceTheyAreSolid) {
  EXPECT_EQ(readBehind({{"monitor.settle_s", "0.3"}}), 1U);
  EXPECT_EQ(readBehind({{"monitor.settle_s", "0.6"}}), 0U);
}

TEST(RunSettings, WhatIsOlderIsWaitedFor) {
  const auto late = [](const char* window) {
    LoopRun run({"id", Eigen::Isometry3d::Identity(), twoLayers()},
                settingsWith({{"monitor.reorder_s", window}}));
    run.observe({2'000'000'000, {0.0, 0.0, 1.5}});
    run.observe({2'300'000'000, {1.0, 0.0, 1.5}});
    run.observe({1'900'000'000, {0.0, 0.0, 1.5}});
    return run.counts().poses_late;
  };
  EXPECT_EQ(late("0.2"), 1U);
  EXPECT_EQ(late("0.5"), 0U);
}

/// The first layer is found 2 mm too high: half a millimetre above the nozzle of the second.
TEST(RunSettings, ALumpAboveTheHeadsClearanceHoldsThePrint) {
  const auto holds = [](const char* clearance) {
    test::SensedWallCase wall;
    wall.settings = settingsWith({{"head.clearance_mm", clearance}});
    wall.layers = 2;
    wall.growth = 3.5 / 1.5;
    const test::SensedWall printed = test::sensedWall(wall);
    return std::any_of(printed.alarms.begin(), printed.alarms.end(),
                       [](const RaisedAlarm& alarm) { return alarm.alarm == LoopAlarm::Lump; });
  };
  EXPECT_TRUE(holds("0.3"));
  EXPECT_FALSE(holds("0.8"));
}

}  // namespace
}  // namespace lamina
