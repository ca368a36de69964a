// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/control/run/loop_run.hpp"
#include "lamina/control/run/standing_alarms.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::SensedWallCase;
using test::SensorDoes;

constexpr std::size_t kBadLayer = 3;

SensedWallCase wallWithBadSensor(SensorDoes does) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.settings.keeps_memory = true;
  wall.settings.loop.silence_s = 0.5;
  wall.sensor = [does](std::size_t layer) { return layer == kBadLayer ? does : SensorDoes::Measure; };
  return wall;
}

/// A wall that is fed to a loop pose by pose, with the clouds up to each.
struct WallFeed {
  const SensedWall& printed;
  LoopRun& run;
  std::size_t tip = 0;
  std::size_t cloud = 0;

  /// Until a condition of the loop holds, or all was fed.
  template <class Holds>
  void until(const Holds& holds) {
    for (; tip < printed.tips.size() && !holds(); ++tip) {
      for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= printed.tips[tip].stamp_ns;
           ++cloud)
        run.see(printed.clouds[cloud]);
      run.observe(printed.tips[tip]);
    }
  }
};

bool stands(const LoopRun& run, LoopAlarm alarm) { return isAmong(run.standing(), alarm); }

/// What a loop that follows the wall knows after a layer; the feed stands where it is known.
LoopMemory memoryOf(WallFeed& feed, std::size_t layer) {
  std::optional<LoopMemory> memory;
  feed.until([&] {
    if (auto news = feed.run.takeNews(); news.memory) memory = std::move(news.memory);
    return memory && memory->layer == layer;
  });
  return *memory;
}

TEST(StandingRun, ResumesTheConditionsThatStoodWhateverCameAfterThem) {
  const SensedWallCase wall = wallWithBadSensor(SensorDoes::KeepSilent);
  const SensedWall printed = sensedWall(wall);
  LoopRun before(printed.part, wall.settings);
  WallFeed feed{printed, before};
  LoopMemory memory = memoryOf(feed, kBadLayer);
  ASSERT_EQ(memory.standing.size(), 1U);
  memory.last_alarm = RaisedAlarm{LoopAlarm::Deviation, LoopReaction::Warn, "off"};
  LoopRun run(printed.part, wall.settings);
  run.resume(memoryFromYaml(toYaml(memory), "kept"));
  ASSERT_TRUE(stands(run, LoopAlarm::Silent));
  EXPECT_EQ(run.standing()[0].reason, before.standing()[0].reason);
  EXPECT_FALSE(stands(run, LoopAlarm::Deviation));
  WallFeed rest{printed, run, feed.tip, feed.cloud};
  rest.until([&] { return run.standing().empty(); });
  EXPECT_EQ(run.place().layer, kBadLayer + 1) << "it was seen again";
}

/// Watches that have just begun have not seen enough to say that a sensor is not stuck.
TEST(StandingRun, KeepsAStuckSensorUntilALayerIsMeasured) {
  const SensedWallCase wall = wallWithBadSensor(SensorDoes::SayTheSame);
  const SensedWall printed = sensedWall(wall);
  LoopRun before(printed.part, wall.settings);
  WallFeed feed{printed, before};
  const LoopMemory memory = memoryOf(feed, kBadLayer);
  LoopRun run(printed.part, wall.settings);
  run.resume(memory);
  WallFeed rest{printed, run, feed.tip, feed.cloud};
  ASSERT_TRUE(stands(run, LoopAlarm::Stuck));
  rest.until([&] { return !stands(run, LoopAlarm::Stuck); });
  EXPECT_EQ(run.place().layer, kBadLayer + 2) << "the next layer is done";
}

TEST(StandingRun, EndsItsConditionsWhenThePrintIsCutOffUntilItGoesOn) {
  const SensedWallCase wall = wallWithBadSensor(SensorDoes::KeepSilent);
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  WallFeed feed{printed, run};
  feed.until([&] { return stands(run, LoopAlarm::Silent); });
  ASSERT_LT(feed.tip + 10, printed.tips.size());
  run.interrupt();
  EXPECT_TRUE(run.standing().empty());
  const std::size_t at = feed.tip;
  feed.until([&] { return feed.tip == at + 10 || !run.standing().empty(); });
  EXPECT_EQ(feed.tip, at + 10) << "nobody expects clouds";
  run.goOn();
  feed.until([&] { return stands(run, LoopAlarm::Silent); });
  EXPECT_LT(feed.tip, at + 15) << "the scan goes on without clouds";
}

}  // namespace
}  // namespace lamina
