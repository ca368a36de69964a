// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Each thing that can go wrong, injected into a print under the loop: the alarm, what is done, and the state.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::calibratedLoop;
using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;
using test::SensorDoes;

constexpr std::size_t kFaultyLayer = 5;

/// One row: what happens, and what has to come of it.
struct Mishap {
  std::string name;
  std::function<void(SensedWallCase& wall)> inject;
  LoopAlarm alarm;
  LoopReaction reaction;
  std::size_t told_by;  ///< layer at whose end it is told at the latest
  LoopState next;       ///< in which the layer after that is laid
};

std::function<SensorDoes(std::size_t)> failing(SensorDoes does, std::size_t layers = 1) {
  return [does, layers](std::size_t layer) {
    return layer >= kFaultyLayer && layer < kFaultyLayer + layers ? does : SensorDoes::Measure;
  };
}

/// Raises a stretch of the wall, once, as a layer is laid.
std::function<void(std::size_t, std::vector<double>&)> raised(std::size_t first, std::size_t end,
                                                              double by_mm) {
  return [=](std::size_t layer, std::vector<double>& heights) {
    for (std::size_t i = first; i < end && layer == kFaultyLayer; ++i) heights[i] += by_mm;
  };
}

/// A stretch of the wall that breaks off, once, with all of its layers.
std::function<void(std::size_t, std::vector<double>&)> brokenOff(std::size_t first, std::size_t end) {
  return [=](std::size_t layer, std::vector<double>& heights) {
    for (std::size_t i = first; i < end && layer == kFaultyLayer; ++i) heights[i] = 0.0;
  };
}

void failSilent(SensedWallCase& wall) {
  wall.settings.loop.silence_s = 0.5;
  wall.sensor = failing(SensorDoes::KeepSilent);
}

void loseSightForGood(SensedWallCase& wall, LossOfSight on_loss) {
  wall.settings.loop.on_loss = on_loss;
  wall.sensor = failing(SensorDoes::KeepSilent, 100);
}

/// A wall with soft ends, scanned there and back, whose stamps come to be late.
void moveOffset(SensedWallCase& wall) {
  wall.scans = 3;
  wall.grows = [](std::size_t, double along_mm) {
    return 1.0 - 0.15 * std::max(0.0, 1.0 - std::min(along_mm, 60.0 - along_mm) / 10.0);
  };
  wall.sensor = failing(SensorDoes::LagBehind, 100);
}

void saturate(SensedWallCase& wall, Replanning replan) {
  wall.settings.loop.replan = replan;
  wall.settings.loop.greatest_amount = 0.05;
}

/// Growth that is lost faster and faster.
void diverge(SensedWallCase& wall) {
  wall.settings.loop.layer_volume = 2.0;
  wall.settings.loop.greatest_amount = 5.0;
  wall.settings.loop.alarm_layers = 10.0;
  wall.grows = [](std::size_t layer, double) {
    return layer < kFaultyLayer ? 1.0 : 0.7 * std::pow(0.8, static_cast<double>(layer - kFaultyLayer));
  };
}

void missAMap(SensedWallCase& wall) {
  wall.misses_map = [](std::size_t layer) { return layer == kFaultyLayer; };
}

std::vector<Mishap> mishapsOfTheSensor() {
  using A = LoopAlarm;
  using R = LoopReaction;
  using S = LoopState;
  constexpr std::size_t at = kFaultyLayer;
  return {
      {"no cloud in a scan", failSilent, A::Silent, R::Coast, at, S::Coasting},
      {"three layers without a cloud, hold",
       [](SensedWallCase& wall) { loseSightForGood(wall, LossOfSight::Hold); }, A::Silent, R::Hold, at + 2,
       S::Coasting},
      {"three layers without a cloud, open",
       [](SensedWallCase& wall) { loseSightForGood(wall, LossOfSight::Open); }, A::Silent, R::Open, at + 2,
       S::Open},
      {"clouds without a pose",
       [](SensedWallCase& wall) {
         wall.settings.loop.silence_s = 0.5;
         wall.sensor = failing(SensorDoes::LoseTransform);
       },
       A::NoTransform, R::Coast, at, S::Coasting},
      {"profiles of no numbers", [](SensedWallCase& wall) { wall.sensor = failing(SensorDoes::SayNothing); },
       A::Stuck, R::Coast, at, S::Coasting},
      {"profiles that stay the same",
       [](SensedWallCase& wall) { wall.sensor = failing(SensorDoes::SayTheSame); }, A::Stuck, R::Coast, at,
       S::Coasting},
      {"points that are not believed",
       [](SensedWallCase& wall) { wall.sensor = failing(SensorDoes::Scatter); }, A::Contested, R::LeaveOut,
       at, S::Coasting},
      {"a time offset that moved", moveOffset, A::TimeOffset, R::Coast, at, S::Coasting},
      {"a sensor noisier than it is said to be", [](SensedWallCase& wall) { wall.noise_mm = 0.04; },
       A::Inconsistent, R::Warn, at, S::Active},
  };
}

std::vector<Mishap> mishapsOfTheProcess() {
  using A = LoopAlarm;
  using R = LoopReaction;
  using S = LoopState;
  constexpr std::size_t at = kFaultyLayer;
  return {
      {"a piece that came off", [](SensedWallCase& wall) { wall.befalls = raised(0, 61, -1.4); }, A::Step,
       R::Hold, at, S::Active},
      {"a piece that came off down to the bed",
       [](SensedWallCase& wall) { wall.befalls = brokenOff(25, 45); }, A::Step, R::Hold, at, S::Active},
      {"a dip", [](SensedWallCase& wall) { wall.befalls = raised(20, 26, -1.9); }, A::Deviation, R::Warn, at,
       S::Active},
      {"a dip that stays",
       [](SensedWallCase& wall) {
         wall.befalls = raised(20, 26, -1.9);
         wall.growth = 1.0;
         wall.settings.loop.greatest_amount = 0.1;  // too little for the next layer to fill it
       },
       A::Deviation, R::Hold, at + 1, S::Active},
      {"a lump within sight of its cells",
       [](SensedWallCase& wall) {
         wall.settings.head_clearance_mm = 0.2;
         wall.befalls = raised(20, 26, 2.0);
       },
       A::Lump, R::Hold, at + 1, S::Active},
      {"a lump as high as the head", [](SensedWallCase& wall) { wall.befalls = raised(20, 26, 7.0); },
       A::Lump, R::Hold, at + 1, S::Active},
      {"limits that are used, hold", [](SensedWallCase& wall) { saturate(wall, Replanning::Hold); },
       A::Saturated, R::Hold, at, S::Active},
      {"limits that are used, off", [](SensedWallCase& wall) { saturate(wall, Replanning::Off); },
       A::Saturated, R::Warn, at, S::Active},
      {"limits that are used, scale", [](SensedWallCase& wall) { saturate(wall, Replanning::Scale); },
       A::Saturated, R::Replan, at, S::Active},
      {"an error that grows", diverge, A::Diverging, R::Coast, at + 4, S::Coasting},
      {"growth that is hardly any",
       [](SensedWallCase& wall) {
         wall.growth = 0.45;
         wall.settings.loop.greatest_amount = wall.settings.loop.layer_volume = 2.0;
         wall.settings.loop.alarm_layers = 10.0;
       },
       A::Growth, R::Warn, at + 3, S::Active},
      {"a map that is late", missAMap, A::MapLate, R::Coast, at, S::Active},
  };
}

/// The layer at whose end the alarm is told first with that reaction; as many as there are if it is not.
std::size_t toldAt(const SensedWall& printed, const Mishap& mishap) {
  std::size_t layer = 0;
  for (; layer < printed.layers.size(); ++layer)
    for (const RaisedAlarm& alarm : printed.layers[layer].alarms)
      if (alarm.alarm == mishap.alarm && alarm.reaction == mishap.reaction) return layer;
  return layer;
}

std::string alarmsOf(const SensedWall& printed) {
  std::string text;
  for (std::size_t k = 0; k < printed.layers.size(); ++k) {
    text += "\nlayer " + std::to_string(k) + " " + toString(printed.layers[k].state);
    for (const RaisedAlarm& alarm : printed.layers[k].alarms)
      text += "\n  " + std::to_string(int(alarm.alarm)) + " " + alarm.reason;
  }
  return text;
}

TEST(SupervisedRun, TellsAndReactsToEachMishap) {
  std::vector<Mishap> mishaps = mishapsOfTheSensor();
  for (const Mishap& mishap : mishapsOfTheProcess()) mishaps.push_back(mishap);
  for (const Mishap& mishap : mishaps) {
    SensedWallCase wall;
    wall.settings = calibratedLoop();
    wall.layers = 12;
    mishap.inject(wall);
    const SensedWall printed = sensedWall(wall);
    SCOPED_TRACE(mishap.name + alarmsOf(printed));
    ASSERT_EQ(printed.layers.size(), wall.layers) << "the print goes on until it is held";
    ASSERT_EQ(printed.maps.size(), wall.layers);
    EXPECT_LE(toldAt(printed, mishap), mishap.told_by);
    EXPECT_EQ(printed.layers.at(mishap.told_by + 1).state, mishap.next);
    for (const CorrectionMap& map : printed.maps) EXPECT_NO_THROW(validate(map));
  }
}

/// The gain of each layer is that of what was laid, and the one without its map was laid as planned.
void expectLearntFromAMiss(const SensedWall& printed, const SensedWallCase& wall) {
  const std::vector<double> gain = test::wallTruth(wall).gain;
  for (std::size_t k = 0; k < wall.layers; ++k)
    EXPECT_NEAR(printed.layers[k].figures.gain_mean, gain[k], 0.003) << k;
  EXPECT_EQ(printed.layers[kFaultyLayer].state, LoopState::Coasting);
}

/// A layer whose map holds from twenty millimetres on, and what is learnt of it.
void expectLaidFromTwentyOn(const SensedWall& printed, const SensedWallCase& wall) {
  EXPECT_EQ(printed.layers[kFaultyLayer].state, LoopState::Active);
  double last = printed.layers[kFaultyLayer - 1].cells.back().amount;
  EXPECT_GT(last, 0.09);
  for (const CellOutcome& cell : printed.layers[kFaultyLayer].cells) {
    const double x = cell.at.x();
    // 0.5 /s at 20 mm/s are 0.0125 a cell: a tenth has faded within 4 to 5 mm.
    EXPECT_LE(std::abs(cell.amount - last), 0.0125 + 1e-12) << x;
    last = cell.amount;
    EXPECT_TRUE(x < 6.0 || (cell.amount == 0.0) == (x < 20.0)) << x;
    EXPECT_TRUE(x < 26.0 || cell.amount > 0.05) << x;
  }
  EXPECT_NEAR(printed.layers[kFaultyLayer].figures.gain_mean, test::wallTruth(wall).gain[kFaultyLayer],
              0.003);
}

/// A layer that is laid as planned where a tenth more was asked for: growth is learnt from what was laid.
TEST(SupervisedRun, LearnsFromALayerWhoseMapWasMissed) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  missAMap(wall);
  const SensedWall printed = sensedWall(wall);
  expectLearntFromAMiss(printed, wall);
  EXPECT_TRUE(printed.maps[kFaultyLayer + 1].paths.size() == 1) << "the next one is corrected";
}

/// The machine may tell it before the loop has come to the layer.
TEST(SupervisedRun, LearnsFromAMissThatIsToldBeforeTheLayer) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  missAMap(wall);
  wall.is_miss_told_early = true;
  const SensedWall printed = sensedWall(wall);
  expectLearntFromAMiss(printed, wall);
  const auto late = std::count_if(printed.alarms.begin(), printed.alarms.end(),
                                  [](const RaisedAlarm& alarm) { return alarm.alarm == LoopAlarm::MapLate; });
  EXPECT_EQ(late, 1);
}

/// Twenty of sixty millimetres go to the machine before their map does: no alarm, and each cell is known by
/// what it was laid with.
TEST(SupervisedRun, LearnsFromALayerWhoseMapHeldFromAPlaceOn) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  missAMap(wall);
  wall.missed_mm = 20.0;
  const SensedWall printed = sensedWall(wall);
  for (const RaisedAlarm& alarm : printed.alarms) EXPECT_NE(alarm.alarm, LoopAlarm::MapLate);
  expectLaidFromTwentyOn(printed, wall);
}

/// Told as missed, and then as laid by its map from twenty millimetres on: the later word holds.
TEST(SupervisedRun, LearnsFromAMapThatCameAfterItWasGivenUp) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  missAMap(wall);
  wall.missed_mm = 20.0;
  wall.operates = [](std::size_t layer, LoopRun& run) {
    if (layer + 1 == kFaultyLayer) run.missMap({kFaultyLayer, 2.0, {}, {}});
  };
  expectLaidFromTwentyOn(sensedWall(wall), wall);
}

/// Neither a map that held from the beginning nor a layer that there is not changes anything.
TEST(SupervisedRun, LearnsNothingFromMapsThatWereNotMissed) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  const SensedWall expected = sensedWall(wall);
  wall.operates = [](std::size_t layer, LoopRun& run) {
    run.missMap({layer, 0.0, {}, PlaceOnLayer{}});
    run.missMap({100 + layer, 2.0, {}, {}});
  };
  const SensedWall printed = sensedWall(wall);
  ASSERT_EQ(printed.maps.size(), expected.maps.size());
  for (std::size_t k = 0; k < printed.maps.size(); ++k)
    EXPECT_EQ(digestOf(printed.maps[k]), digestOf(expected.maps[k])) << k;
  EXPECT_EQ(printed.alarms.size(), expected.alarms.size());
}

/// Told once a layer, however many further maps it has, and counted each time: nothing is learnt from that.
TEST(SupervisedRun, TellsOfFurtherMapsThatAreNotUsed) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  const SensedWall expected = sensedWall(wall);
  wall.operates = [](std::size_t layer, LoopRun& run) {
    if (layer != kFaultyLayer) return;
    run.refuseTrim(layer, "it changes the speed");
    run.refuseTrim(layer, "it changes the speed");
    run.refuseTrim(100, "of no layer");
  };
  const SensedWall printed = sensedWall(wall);
  EXPECT_EQ(expected.counts.trims_refused, 0U);
  EXPECT_EQ(printed.counts.trims_refused, 2U);
  ASSERT_EQ(printed.alarms.size(), expected.alarms.size() + 1);
  const auto& alarms = printed.layers[kFaultyLayer].alarms;
  const auto told = std::find_if(alarms.begin(), alarms.end(), [](const RaisedAlarm& alarm) {
    return alarm.alarm == LoopAlarm::MapLate && alarm.reaction == LoopReaction::Warn;
  });
  ASSERT_NE(told, alarms.end()) << "in the report of the layer";
  EXPECT_NE(told->reason.find("of layer 5 is not used: it changes the speed"), std::string::npos)
      << told->reason;
  ASSERT_EQ(printed.maps.size(), expected.maps.size());
  for (std::size_t k = 0; k < printed.maps.size(); ++k)
    EXPECT_EQ(digestOf(printed.maps[k]), digestOf(expected.maps[k])) << k;
}

/// Nothing is missed where nothing was to be changed.
TEST(SupervisedRun, TellsNothingOfAnEmptyMapThatWasNotWaitedFor) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  wall.operates = [](std::size_t layer, LoopRun& run) {
    if (layer == 0) run.missMap({0, 0.0, {}, {}});
  };
  for (const RaisedAlarm& alarm : sensedWall(wall).alarms) EXPECT_NE(alarm.alarm, LoopAlarm::MapLate);
}

/// A wall that grows to 2.2 times as much from the faulty layer on, under a loop of that gain.
SensedWall leapingWall(double gain, const std::function<void(std::size_t, LoopRun&)>& operates = {}) {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  wall.settings.loop.gain = gain;
  wall.settings.loop.alarm_layers = 10.0;
  wall.layers = 12;
  wall.grows = [](std::size_t layer, double) { return layer < kFaultyLayer ? 1.0 : 2.2; };
  wall.operates = operates;
  return sensedWall(wall);
}

/// 1.98 over a gain of 0.9 that goes to 1.22: the layer grew 1.6 times what is learnt, and a loop's gain of
/// 1.4 is 2.3 of the growth that is left to learn. The bound is 2: a gain of 1.1 is below it.
TEST(SupervisedRun, ChecksItsStabilityByWhatTheGrowthToldWhenTheGainHasChanged) {
  const SensedWall blocked = leapingWall(1.4);
  EXPECT_EQ(blocked.layers[kFaultyLayer].state, LoopState::Active);
  EXPECT_EQ(blocked.layers[kFaultyLayer + 1].state, LoopState::Blocked) << alarmsOf(blocked);
  EXPECT_NE(blocked.status.reason.find("times what is learnt by now"), std::string::npos)
      << blocked.status.reason;
  EXPECT_EQ(leapingWall(1.1).layers[kFaultyLayer + 1].state, LoopState::Active);
}

/// Once the growth is learnt an operator may let it go on.
TEST(SupervisedRun, IsCheckedAnewWhenItIsAskedAfterItWasBlocked) {
  std::vector<LoopState> asked;
  leapingWall(1.4, [&](std::size_t layer, LoopRun& run) {
    if (layer > kFaultyLayer) asked.push_back(run.request(LoopRequest::Active).state);
  });
  ASSERT_EQ(asked.size(), 6U);
  EXPECT_EQ(asked.front(), LoopState::Blocked);
  EXPECT_EQ(asked.back(), LoopState::Active);
}

/// The same print without any mishap: whatever is told above is told of that alone.
TEST(SupervisedRun, TellsNothingWhereNothingIsWrong) {
  for (const int scans : {1, 3}) {
    SensedWallCase wall;
    wall.settings = calibratedLoop();
    wall.layers = 12;
    wall.scans = scans;
    for (const RaisedAlarm& alarm : sensedWall(wall).alarms)
      EXPECT_EQ(alarm.alarm, LoopAlarm::Inconsistent) << alarm.reason;  // cells that are all alike
  }
}

}  // namespace
}  // namespace lamina
