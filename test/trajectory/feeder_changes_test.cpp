// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Changes of feed, flow and power while a trajectory is handed over.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "fed_gantry.hpp"
#include "lamina/base/error.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {
namespace {

using test::expectSame;
using test::fastFeeder;
using test::powderSettings;
using test::timedGantry;
using test::trajectoryFeederLine;

constexpr double kFeederStep = 1e-3;  // s

TEST(TrajectoryFeeder, GoesOnFasterThanPlannedAndBackAgain) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, fastFeeder());
  feeder.setSpeed(2.0, 0.5);
  // At 16.5 mm after 0.6 s; 0.1 s and 4.5 mm to 60 mm/s, 3 mm at that, 0.2 s and 6 mm to rest.
  EXPECT_NEAR(feeder.at(0.6).velocity[0], 30.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.7).velocity[0], 60.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.7).position[0], 21.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.72).process.flow_mm3_s, 60.0 * crossSection({0.4, 0.2}), 1e-9);
  EXPECT_NEAR(feeder.restTime(), 0.7 + 3.0 / 60.0 + 0.2, 1e-9);
  feeder.setSpeed(1.0, 0.6);
  // 4.5 mm from 60 to 30 mm/s: at 25.5 mm; 3 mm at that, 1.5 mm to rest.
  EXPECT_NEAR(feeder.at(0.8).velocity[0], 30.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.8).position[0], 25.5, 1e-9);
  EXPECT_NEAR(feeder.restTime(), 0.8 + 3.0 / 30.0 + 0.1, 1e-9);
}

TEST(TrajectoryFeeder, BrakesFromMoreThanThePlannedSpeedAsHardAsTheLimitsAllow) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, fastFeeder());
  feeder.setSpeed(2.0, 0.2);
  // At 7.5 mm after 0.3 s, at 12 mm and 60 mm/s after 0.4 s; 0.2 s and 6 mm to rest.
  feeder.pause(0.3);
  EXPECT_NEAR(feeder.restTime(), 0.6, 1e-9);
  EXPECT_NEAR(feeder.at(0.6).position[0], 18.0, 1e-9);
}

TEST(TrajectoryFeeder, IsNoFasterThanJointsAllow) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const Toolpath column{"column", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {0, 0, 30.2})}}}};
  const TimedPath timed = timedGantry(column, settings);
  TrajectoryFeeder feeder(timed, fastFeeder());
  // z takes 50 mm/s, and 250 mm/s²: 0.2 s and 5 mm up, 20 mm at that. As planned 0.12 s and 1.8 mm, 26.4 mm.
  const SpeedChange change = feeder.speedChange(3.0);
  EXPECT_NEAR(change.reached, (0.24 + 26.4 / 30.0) / (0.4 + 20.0 / 50.0), 1e-9);
  EXPECT_EQ(feeder.speedChange(0.5).reached, 0.5);
  feeder.setSpeed(change, 0.0);
  double fastest = 0.0;
  for (double t = 0.0; t < feeder.restTime(); t += kFeederStep)
    fastest = std::max(fastest, feeder.at(t).velocity.cwiseAbs()[2]);
  EXPECT_NEAR(fastest, 50.0, 1e-9);
}

TEST(TrajectoryFeeder, LeadsFlowAndPowerToTheirShares) {
  Toolpath line = trajectoryFeederLine();
  line.layers[0].paths[0].values = {
      {"laser_power_w", 800.0}, {"screw_rpm", 12.0}, {"powder_g_min", 5.0}, {"gas_l_min", 15.0}};
  const TimedPath timed = timedGantry(line, powderSettings());
  TrajectoryFeederSettings ramped;
  ramped.reaction_s = 0.1;
  ramped.override_ramp_s = 0.5;
  TrajectoryFeeder feeder(timed, ramped);
  feeder.setShare(OverrideKind::Flow, 1.4, 0.3);
  feeder.setShare(OverrideKind::Power, 0.8, 0.5);
  const auto shares = [&](double time_s) {
    const JointState planned = timed.at(time_s);
    const JointState now = feeder.at(time_s);
    expectSame(now, planned);
    const ProcessLevels& levels = now.process.levels;
    EXPECT_EQ(levels[ProcessLevel::Gas], 15.0);
    EXPECT_EQ(now.process.is_laser_on, planned.process.is_laser_on);
    const double flow = now.process.flow_mm3_s / planned.process.flow_mm3_s;
    EXPECT_NEAR(levels[ProcessLevel::ScrewSpeed] / planned.process.levels[ProcessLevel::ScrewSpeed], flow,
                1e-12);
    EXPECT_NEAR(levels[ProcessLevel::Powder] / 5.0, flow, 1e-12);
    return std::pair(flow, levels[ProcessLevel::LaserPower] / 800.0);
  };
  // From 0.4 s on, 0.2 s for 0.4; from 0.6 s on, 0.1 s for 0.2.
  for (const auto& [time_s, flow, power] :
       {std::tuple{0.39, 1.0, 1.0}, std::tuple{0.5, 1.2, 1.0}, std::tuple{0.6, 1.4, 1.0},
        std::tuple{0.65, 1.4, 0.9}, std::tuple{0.7, 1.4, 0.8}, std::tuple{0.9, 1.4, 0.8}}) {
    const auto found = shares(time_s);
    EXPECT_NEAR(found.first, flow, 1e-9) << time_s;
    EXPECT_NEAR(found.second, power, 1e-9) << time_s;
  }
  // From half of a ramp on it goes the other way.
  feeder.setShare(OverrideKind::Power, 0.9, 0.55);
  EXPECT_NEAR(shares(0.65).second, 0.9, 1e-9);
  EXPECT_NEAR(shares(0.8).second, 0.9, 1e-9);
}

TEST(TrajectoryFeeder, HandsOverAgainWhatAShareChanges) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  while (feeder.next(0.2)) continue;
  feeder.setShare(OverrideKind::Flow, 0.5, 0.2);
  const auto chunk = feeder.next(0.2);
  ASSERT_TRUE(chunk) << "what was handed over has another flow";
  EXPECT_NEAR(chunk->points.front().time_s, 0.252, 1e-9) << "the first point after the reaction";
  EXPECT_LT(chunk->points[10].process.flow_mm3_s, timed.at(0.29).process.flow_mm3_s);
}

TEST(TrajectoryFeeder, RefusesSharesOfWhatIsNotThere) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  for (const double share : {0.0, 0.09, 3.1, -1.0, std::nan("")})
    EXPECT_THROW(feeder.setShare(OverrideKind::Flow, share, 0.1), InvalidInput) << share;
  EXPECT_THROW(feeder.setShare(OverrideKind::Power, 0.9, 0.1), InvalidInput) << "no path states its power";
  EXPECT_THROW(feeder.setShare(OverrideKind::Feed, 0.9, 0.1), InvalidInput);
  EXPECT_EQ(feeder.at(0.5).process, timed.at(0.5).process);
}

/// Of 0.05 s, which a change may take half of.
TEST(TrajectoryFeeder, AChangeOfSpeedThatIsComputedTooLateChangesNothing) {
  const TimedPath timed = timedGantry(test::twoLayers(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  const TrajectoryFeeder planned(timed, {});
  JointState last;
  while (const auto chunk = feeder.next(0.3)) last = chunk->points.back();
  const SpeedChange half = feeder.speedChange(0.5);
  EXPECT_FALSE(feeder.setSpeed(half, 0.3, [] { return 0.33; }));
  for (double time_s = 0.0; time_s < timed.duration(); time_s += 0.01)
    expectSame(feeder.at(time_s), planned.at(time_s));
  EXPECT_FALSE(feeder.next(0.3)) << "nothing is replaced";
  EXPECT_TRUE(feeder.setSpeed(half, 0.36, [] { return 0.38; }));
  expectSame(feeder.at(0.41), planned.at(0.41));
  EXPECT_GT(feeder.restTime(), planned.restTime() + 0.1);
  const auto chunk = feeder.next(0.38);
  ASSERT_TRUE(chunk);
  EXPECT_NEAR(chunk->points.front().time_s, 0.412, 1e-9) << "the first point after 0.36 + 0.05 s";
}

}  // namespace
}  // namespace lamina
