// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A print whose clouds come without poses of the nozzle.
#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/control/run/loop_run.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;

SensedWallCase oneLayer() {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = 1;
  return wall;
}

std::ptrdiff_t lossesOfPose(const LoopNews& news) {
  return std::count_if(news.alarms.begin(), news.alarms.end(),
                       [](const RaisedAlarm& each) { return each.alarm == LoopAlarm::NoTransform; });
}

TEST(PoselessRun, SaysThatNoPoseIsKnown) {
  const SensedWallCase wall = oneLayer();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  std::int64_t last_ns = 0;
  for (const StampedTip& pose : printed.tips) {
    run.observe(pose);
    last_ns = pose.stamp_ns;
    if (run.place().is_scanning) break;
  }
  ASSERT_TRUE(run.place().is_scanning);
  run.hear(last_ns + 1'900'000'000);
  EXPECT_EQ(run.status().state, LoopState::Active);
  run.hear(last_ns + 2'200'000'000);
  EXPECT_EQ(run.status().state, LoopState::Coasting);
  EXPECT_EQ(lossesOfPose(run.takeNews()), 1);
}

/// Clouds that something else than the nozzle's poses places go on being read meanwhile.
TEST(PoselessRun, SaysOnceThatNoPoseIsKnownAndAgainTheNextTime) {
  const SensedWallCase wall = oneLayer();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  StampedTip last;
  for (const StampedTip& pose : printed.tips) {
    run.observe(last = pose);
    if (run.place().is_scanning) break;
  }
  const auto goOn = [&](int clouds) {
    SensedCloud cloud = printed.clouds[0];
    for (int i = 0; i < clouds; ++i) {
      cloud.stamp_ns = last.stamp_ns + (i + 1) * 20'000'000LL;
      run.hear(cloud.stamp_ns);
      run.see(cloud);
    }
    const auto lost = lossesOfPose(run.takeNews());
    last.stamp_ns += (clouds + 1) * 20'000'000LL;
    run.observe(last);
    return lost;
  };
  EXPECT_EQ(goOn(200), 1);
  EXPECT_EQ(goOn(80), 0) << "1.6 s";
  EXPECT_EQ(goOn(200), 1);
}

TEST(PoselessRun, SaysNothingOfPosesOnceAllIsDone) {
  const SensedWallCase wall = oneLayer();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  for (const StampedTip& pose : printed.tips) run.observe(pose);
  run.finish();
  run.takeNews();
  for (int i = 0; i <= 40; ++i) run.hear(wall.start_ns - 100'000'000'000 + i * 100'000'000LL);
  EXPECT_TRUE(run.takeNews().alarms.empty());
}

TEST(PoselessRun, SaysThatNoPoseEverCame) {
  const SensedWallCase wall = oneLayer();
  LoopRun run(sensedWall(wall).part, wall.settings);
  for (int i = 0; i <= 19; ++i) run.hear(wall.start_ns + i * 100'000'000LL);
  EXPECT_TRUE(run.takeNews().alarms.empty());
  run.hear(wall.start_ns + 2'100'000'000);
  EXPECT_EQ(run.status().state, LoopState::Coasting);
  EXPECT_EQ(lossesOfPose(run.takeNews()), 1);
}

/// The clock of the machine is set back, not that of ROS: tf takes no transform that is so old.
TEST(PoselessRun, SaysThatNoPoseComesByAClockThatWasSetBack) {
  const SensedWallCase wall = oneLayer();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  for (std::size_t i = 0; i < 50; ++i) run.observe(printed.tips[i]);
  const std::int64_t last_ns = printed.tips[49].stamp_ns;
  const std::int64_t back_ns = last_ns - 40'000'000'000;
  run.hear(last_ns - 29'000'000'000);
  run.hear(back_ns);
  run.hear(back_ns + 1'900'000'000);
  EXPECT_TRUE(run.takeNews().alarms.empty());
  run.hear(back_ns + 2'100'000'000);
  EXPECT_EQ(lossesOfPose(run.takeNews()), 1);
}

}  // namespace
}  // namespace lamina
