// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_run.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "lamina/base/error.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::calibratedLoop;
using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;
using test::SensorDoes;

SensedWallCase wallCase() {
  SensedWallCase wall;
  wall.settings = calibratedLoop();
  return wall;
}

std::vector<std::string> digestsOf(const std::vector<CorrectionMap>& maps) {
  std::vector<std::string> digests;
  for (const CorrectionMap& map : maps) digests.push_back(digestOf(map));
  return digests;
}

bool raises(const std::vector<RaisedAlarm>& alarms, LoopAlarm alarm) {
  return std::any_of(alarms.begin(), alarms.end(),
                     [&](const RaisedAlarm& each) { return each.alarm == alarm; });
}

double meanAmount(const CorrectionMap& map) {
  if (map.paths.empty()) return 0.0;
  double sum = 0.0;
  for (const PointCorrection& place : map.paths[0].stations) sum += place.amount;
  return sum / static_cast<double>(map.paths[0].stations.size());
}

TEST(LoopRun, CorrectsAndLearnsAsWorkedOut) {
  const SensedWallCase wall = wallCase();
  const test::WallTruth truth = test::wallTruth(wall);
  const SensedWall printed = sensedWall(wall);
  ASSERT_EQ(printed.layers.size(), wall.layers);
  ASSERT_EQ(printed.maps.size(), wall.layers);
  for (std::size_t k = 0; k < wall.layers; ++k) {
    const LayerFigures& figures = printed.layers[k].figures;
    EXPECT_EQ(printed.maps[k].layer, k);
    EXPECT_DOUBLE_EQ(figures.coverage, 1.0) << k;
    EXPECT_NEAR(figures.mean_error_mm, truth.error_mm[k], 0.01) << k;
    EXPECT_NEAR(figures.gain_mean, truth.gain[k], 0.01) << k;
    EXPECT_NEAR(meanAmount(printed.maps[k]), truth.amount[k], 0.01) << k;
  }
  // Cells that are all alike scatter less than any process does.
  for (const RaisedAlarm& alarm : printed.alarms)
    EXPECT_EQ(alarm.alarm, LoopAlarm::Inconsistent) << alarm.reason;
  EXPECT_EQ(printed.status.state, LoopState::Active);
}

TEST(LoopRun, CountsEveryCloud) {
  const SensedWall printed = sensedWall(wallCase());
  const LoopCounts& counts = printed.counts;
  EXPECT_EQ(counts.clouds, printed.clouds.size());
  EXPECT_EQ(counts.clouds,
            counts.clouds_read + counts.clouds_late + counts.clouds_stuck + counts.clouds_waiting);
  EXPECT_EQ(counts.clouds_read, counts.clouds);
  EXPECT_EQ(counts.points.received, counts.points.accounted());
  EXPECT_GT(counts.readings_used, 8U * 100U);
}

/// Feeds the wall's messages in an order of one's own.
std::vector<CorrectionMap> mapsOf(const SensedWall& printed, const LoopRunSettings& settings,
                                  const std::vector<std::size_t>& order) {
  LoopRun run(printed.part, settings);
  for (const std::size_t i : order) {
    if (i < printed.tips.size())
      run.observe(printed.tips[i]);
    else
      run.see(printed.clouds[i - printed.tips.size()]);
  }
  run.finish();
  return run.takeNews().maps;
}

std::int64_t stampOf(const SensedWall& printed, std::size_t i) {
  return i < printed.tips.size() ? printed.tips[i].stamp_ns
                                 : printed.clouds[i - printed.tips.size()].stamp_ns;
}

TEST(LoopRun, GivesTheSameBitsHoweverThingsAreDelayed) {
  SensedWallCase wall = wallCase();
  wall.layers = 4;
  wall.length_mm = 20.0;
  const SensedWall printed = sensedWall(wall);
  const auto expected = digestsOf(printed.maps);
  EXPECT_TRUE(rc::check("within the window", [&] {
    // Each message comes up to 0.4 s of the stamps late; the window is 0.5 s.
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<std::pair<double, std::size_t>> arrivals;
    for (std::size_t i = 0; i < printed.tips.size() + printed.clouds.size(); ++i)
      arrivals.emplace_back(static_cast<double>(stampOf(printed, i)) + random.uniform(0.0, 0.4e9), i);
    std::sort(arrivals.begin(), arrivals.end());
    std::vector<std::size_t> order;
    for (const auto& [at, i] : arrivals) order.push_back(i);
    RC_ASSERT(digestsOf(mapsOf(printed, wall.settings, order)) == expected);
  }));
}

TEST(LoopRun, CountsWhatComesTooLate) {
  LoopRun run(sensedWall(wallCase()).part, calibratedLoop());
  run.observe({2'000'000'000, {0, 0, 1.5}});
  run.observe({3'000'000'000, {1, 0, 1.5}});
  run.observe({2'100'000'000, {0.5, 0, 1.5}});  // not passed yet: waits within the window
  run.observe({1'000'000'000, {0, 0, 1.5}});
  run.see({1'000'000'000, test::sensorOver({0, 0, 1.5}), {}});
  EXPECT_EQ(run.counts().poses_late, 1U);
  EXPECT_EQ(run.counts().clouds_late, 1U);
}

/// A layer without any cloud: the loop coasts by what it has learnt, and is active again a measured layer
/// later.
TEST(LoopRun, CoastsWhileTheSensorIsSilent) {
  SensedWallCase wall = wallCase();
  wall.settings.loop.silence_s = 0.5;
  wall.sensor = [](std::size_t layer) { return layer == 4 ? SensorDoes::KeepSilent : SensorDoes::Measure; };
  const SensedWall printed = sensedWall(wall);
  ASSERT_EQ(printed.layers.size(), wall.layers);
  EXPECT_TRUE(raises(printed.layers[4].alarms, LoopAlarm::Silent));
  EXPECT_FALSE(printed.layers[4].figures.is_measured);
  EXPECT_EQ(printed.layers[4].state, LoopState::Active);
  EXPECT_EQ(printed.layers[5].state, LoopState::Coasting);
  EXPECT_EQ(printed.layers[6].state, LoopState::Active);
  const double learnt = printed.layers[3].figures.gain_mean;
  EXPECT_NEAR(meanAmount(printed.maps[5]), 1.0 / learnt - 1.0, 0.01) << "no term of the error";
}

TEST(LoopRun, DropsTheCloudsOfAStuckSensor) {
  for (const SensorDoes does : {SensorDoes::SayNothing, SensorDoes::SayTheSame}) {
    SensedWallCase wall = wallCase();
    wall.sensor = [does](std::size_t layer) { return layer == 4 ? does : SensorDoes::Measure; };
    const SensedWall printed = sensedWall(wall);
    EXPECT_TRUE(raises(printed.layers[4].alarms, LoopAlarm::Stuck));
    EXPECT_EQ(printed.layers[5].state, LoopState::Coasting);
    EXPECT_EQ(printed.layers[6].state, LoopState::Active);
    EXPECT_GT(printed.counts.clouds_stuck, 50U);
    EXPECT_EQ(printed.layers[4].figures.gain_mean, printed.layers[3].figures.gain_mean)
        << "the profiles by which it was found to be stuck teach no gain";
    for (const CorrectionMap& map : printed.maps) EXPECT_LT(std::abs(meanAmount(map)), 0.25) << map.layer;
  }
}

/// What came of a print by a live sensor beside one, "left", that is stuck from half of the print on and says
/// that each layer is as high as planned.
struct StuckBeside {
  LoopNews news;
  LoopCounts counts;
};

/// @param silent_from  number of the live sensor's cloud from which on it is silent
StuckBeside stuckBeside(const SensedWall& printed, const LoopRunSettings& settings, std::size_t silent_from) {
  LoopRun run(printed.part, settings);
  const std::int64_t from_ns = printed.tips[printed.tips.size() / 2].stamp_ns;
  std::size_t cloud = 0;
  for (const StampedTip& tip : printed.tips) {
    run.observe(tip);
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= tip.stamp_ns; ++cloud) {
      run.hear(printed.clouds[cloud].stamp_ns);
      if (cloud < silent_from) run.see(printed.clouds[cloud]);
      SensedCloud stuck = printed.clouds[cloud];
      if (stuck.stamp_ns < from_ns) continue;
      stuck.sensor = "left";
      for (Point3& point : stuck.profiles[0]) point.z() = 65.0;
      run.see(std::move(stuck));
    }
  }
  run.finish();
  return {run.takeNews(), run.counts()};
}

TEST(LoopRun, DropsTheCloudsOfAStuckSensorBesideALiveOne) {
  const SensedWallCase wall = wallCase();
  const SensedWall printed = sensedWall(wall);
  const auto [news, counts] = stuckBeside(printed, wall.settings, printed.clouds.size());
  std::vector<RaisedAlarm> stuck;
  std::copy_if(news.alarms.begin(), news.alarms.end(), std::back_inserter(stuck),
               [](const RaisedAlarm& each) { return each.alarm == LoopAlarm::Stuck; });
  ASSERT_EQ(stuck.size(), 1U);
  EXPECT_EQ(stuck[0].reaction, LoopReaction::Warn);
  EXPECT_NE(stuck[0].reason.find("of sensor 'left'"), std::string::npos) << stuck[0].reason;
  EXPECT_FALSE(raises(news.alarms, LoopAlarm::Silent));
  EXPECT_GT(counts.clouds_stuck, 200U);
  ASSERT_EQ(news.layers.size(), wall.layers);
  EXPECT_FALSE(news.layers[4].figures.is_measured);
  EXPECT_EQ(news.layers[4].figures.gain_mean, news.layers[3].figures.gain_mean)
      << "what it said before it was found out taught nothing";
  EXPECT_EQ(news.layers[5].state, LoopState::Coasting);
  EXPECT_EQ(news.layers[6].state, LoopState::Active);
  for (const std::size_t layer : {6U, 7U})
    EXPECT_NEAR(news.layers[layer].figures.mean_error_mm, printed.layers[layer].figures.mean_error_mm, 0.05)
        << layer;
}

/// Within the scan, and not at its end: what the stuck sensor sends measures nothing.
TEST(LoopRun, SaysThatTheLiveSensorBesideAStuckOneIsSilent) {
  SensedWallCase wall = wallCase();
  wall.settings.loop.silence_s = 0.5;
  const SensedWall printed = sensedWall(wall);
  const std::size_t silent_from = printed.clouds.size() / wall.layers * 6;
  const LoopNews news = stuckBeside(printed, wall.settings, silent_from).news;
  ASSERT_EQ(news.layers.size(), wall.layers);
  EXPECT_FALSE(raises(news.layers[5].alarms, LoopAlarm::Silent));
  const auto& alarms = news.layers[6].alarms;
  const auto silent = std::find_if(alarms.begin(), alarms.end(),
                                   [](const auto& each) { return each.alarm == LoopAlarm::Silent; });
  ASSERT_NE(silent, alarms.end());
  EXPECT_EQ(silent->reason.find("no cloud of a sensor that is not stuck for 0.5"), 0U) << silent->reason;
  EXPECT_FALSE(news.layers[6].figures.is_measured);
  EXPECT_EQ(news.layers[7].state, LoopState::Coasting);
}

TEST(LoopRun, IsBlockedWithoutCalibration) {
  SensedWallCase wall = wallCase();
  wall.settings.calibration.is_time_offset_trusted = false;
  const SensedWall printed = sensedWall(wall);
  EXPECT_EQ(printed.status.state, LoopState::Blocked);
  EXPECT_NE(printed.status.reason.find("time offset"), std::string::npos);
  for (const CorrectionMap& map : printed.maps) EXPECT_TRUE(map.paths.empty()) << map.layer;
  LoopRun run(printed.part, wall.settings);
  EXPECT_EQ(run.request(LoopRequest::Active).state, LoopState::Blocked);
  EXPECT_EQ(run.request(LoopRequest::Off).state, LoopState::Off);
}

/// Switched off amid a layer: the next one begins with what this one ends with, and goes to nothing no faster
/// than the feeder follows.
TEST(LoopRun, FadesWhenItIsSwitchedOff) {
  SensedWallCase wall = wallCase();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  std::size_t cloud = 0;
  std::vector<CorrectionMap> maps;
  bool is_off = false;
  for (const StampedTip& pose : printed.tips) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= pose.stamp_ns; ++cloud)
      run.see(printed.clouds[cloud]);
    run.observe(pose);
    if (!is_off && run.place().layer == 5 && run.place().along_mm > 20.0) {
      EXPECT_EQ(run.request(LoopRequest::Off).state, LoopState::Off);
      is_off = true;
    }
  }
  run.finish();
  maps = run.takeNews().maps;
  ASSERT_EQ(maps.size(), wall.layers) << "the print goes on";
  const double last = maps[5].paths.at(0).stations.back().amount;
  EXPECT_GT(last, 0.05);
  const double steepest = wall.settings.loop.feeder_rate_s / wall.speed_mm_s;  // 1/mm
  const PathCorrection& path = maps[6].paths.at(0);
  EXPECT_NEAR(path.stations.front().amount, last, steepest * path.spacing_mm * (1.0 + 1e-9));
  for (std::size_t i = 1; i < path.stations.size(); ++i)
    EXPECT_LE(std::abs(path.stations[i].amount - path.stations[i - 1].amount),
              steepest * path.spacing_mm * (1.0 + 1e-9));
  EXPECT_EQ(path.stations.back().amount, 0.0);
  EXPECT_TRUE(maps[7].paths.empty());
}

/// The first event that a run which goes on after a layer may see.
std::size_t tipsUntil(const SensedWall& printed, std::size_t layer) {
  LayerProgress progress(printed.part.toolpath, {});
  std::size_t tip = 0;
  while (tip < printed.tips.size() && progress.observe(printed.tips[tip].tip).layer <= layer) ++tip;
  return tip;
}

/// Tips from one on, and the clouds since.
void feedFrom(LoopRun& run, const SensedWall& printed, std::size_t first) {
  std::size_t cloud = 0;
  while (cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns < printed.tips[first].stamp_ns)
    ++cloud;
  for (std::size_t i = first; i < printed.tips.size(); ++i) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= printed.tips[i].stamp_ns;
         ++cloud)
      run.see(printed.clouds[cloud]);
    run.observe(printed.tips[i]);
  }
  run.finish();
}

TEST(LoopRun, GoesOnWhenTheClockOfTheStampsGoesBack) {
  const SensedWallCase wall = wallCase();
  SensedWall printed = sensedWall(wall);
  constexpr std::int64_t kBack = 900'000'000'000;  // ns
  LoopRun run(printed.part, wall.settings);
  std::size_t cloud = 0;
  const auto feed = [&](std::size_t from, std::size_t until) {
    for (std::size_t i = from; i < until; ++i) {
      const std::int64_t stamp_ns = printed.tips[i].stamp_ns;
      for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= stamp_ns; ++cloud)
        run.see(printed.clouds[cloud]);
      run.observe(printed.tips[i]);
    }
  };
  const std::size_t half = tipsUntil(printed, 3);
  feed(0, half);
  run.restartClock();
  for (StampedTip& tip : printed.tips) tip.stamp_ns -= kBack;
  for (SensedCloud& each : printed.clouds) each.stamp_ns -= kBack;
  feed(half, printed.tips.size());
  run.finish();
  EXPECT_EQ(run.counts().poses_late, 0U);
  EXPECT_EQ(run.counts().clouds_late, 0U);
  const LoopNews news = run.takeNews();
  ASSERT_EQ(news.layers.size(), wall.layers);
  for (const LayerOutcome& layer : news.layers)
    EXPECT_GT(layer.figures.coverage, 0.95) << layer.figures.layer;
}

/// What the loop knew when a layer was done.
LoopMemory memoryAfter(const SensedWall& printed, const LoopRunSettings& settings, std::size_t layer) {
  LoopRun run(printed.part, settings);
  std::size_t cloud = 0;
  for (const StampedTip& pose : printed.tips) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= pose.stamp_ns; ++cloud)
      run.see(printed.clouds[cloud]);
    run.observe(pose);
    const LoopNews news = run.takeNews();
    if (news.memory && news.memory->layer == layer) return *news.memory;
  }
  ADD_FAILURE() << "layer " << layer << " was not done";
  return {};
}

SensedWallCase keptWall() {
  SensedWallCase wall = wallCase();
  wall.settings.keeps_memory = true;
  wall.settings.material = "steel";
  return wall;
}

TEST(LoopRun, GoesOnFromItsMemoryToTheSameBits) {
  const SensedWallCase wall = keptWall();
  const SensedWall printed = sensedWall(wall);
  const auto expected = digestsOf(printed.maps);
  for (const std::size_t layer : {std::size_t{0}, std::size_t{3}, std::size_t{6}}) {
    const std::string kept = toYaml(memoryAfter(printed, wall.settings, layer));
    LoopRun run(printed.part, wall.settings);
    run.resume(memoryFromYaml(kept, "kept"));
    feedFrom(run, printed, tipsUntil(printed, layer));
    const LoopNews news = run.takeNews();
    EXPECT_EQ(digestsOf(news.maps), std::vector<std::string>(expected.begin() + layer + 1, expected.end()));
    ASSERT_FALSE(news.layers.empty());
    EXPECT_EQ(news.layers.front().figures.layer, layer + 1);
    EXPECT_EQ(news.layers.back().figures.rmse_mm, printed.layers.back().figures.rmse_mm);
  }
}

TEST(LoopRun, RemembersItsLastAlarm) {
  SensedWallCase wall = keptWall();
  wall.settings.loop.silence_s = 0.5;
  wall.sensor = [](std::size_t layer) { return layer == 3 ? SensorDoes::KeepSilent : SensorDoes::Measure; };
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  run.resume(memoryFromYaml(toYaml(memoryAfter(printed, wall.settings, 3)), "kept"));
  EXPECT_EQ(run.status().state, LoopState::Coasting);
  ASSERT_TRUE(run.lastAlarm());
  EXPECT_EQ(run.lastAlarm()->alarm, LoopAlarm::Silent);
  EXPECT_EQ(run.lastAlarm()->reaction, LoopReaction::Coast);
  EXPECT_EQ(run.lastAlarm()->reason.find("no cloud for 0."), 0U) << run.lastAlarm()->reason;
  LoopRun first(printed.part, wall.settings);
  first.resume(memoryFromYaml(toYaml(memoryAfter(printed, wall.settings, 0)), "kept"));
  EXPECT_FALSE(first.lastAlarm());
}

/// Nobody gave the machine its maps of the layers that were begun meanwhile.
TEST(LoopRun, TakesLayersThatItMissedForLaidAsPlanned) {
  const SensedWallCase wall = keptWall();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  run.resume(memoryAfter(printed, wall.settings, 3));
  feedFrom(run, printed, tipsUntil(printed, 5) + 30);
  const LoopNews news = run.takeNews();
  ASSERT_GE(news.layers.size(), 3U);
  EXPECT_GT(std::abs(meanAmount(news.maps[0])), 0.05) << "layer 4 had its map";
  EXPECT_EQ(meanAmount(news.maps[1]), 0.0);
  EXPECT_EQ(meanAmount(news.maps[2]), 0.0);
  EXPECT_EQ(news.maps[2].layer, 6U);
  EXPECT_TRUE(raises(news.layers[1].alarms, LoopAlarm::MapLate)) << "of layer 5";
  EXPECT_GT(std::abs(meanAmount(news.maps[3])), 0.05) << "seen from layer 6 on";
}

TEST(LoopRun, RefusesTheMemoryOfAnotherPrint) {
  const SensedWallCase wall = keptWall();
  const SensedWall printed = sensedWall(wall);
  const LoopMemory memory = memoryAfter(printed, wall.settings, 3);
  const auto refusal = [&](const std::function<void(LoopMemory&)>& change) {
    LoopMemory changed = memory;
    change(changed);
    LoopRun run(printed.part, wall.settings);
    try {
      run.resume(changed);
    } catch (const InvalidInput& error) {
      EXPECT_EQ(run.takeNews().maps.at(0).layer, 0U) << "at its beginning";
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal([](LoopMemory&) {}), "");
  EXPECT_NE(refusal([](LoopMemory& of) { of.identity.material = "bronze"; }).find("bronze"),
            std::string::npos);
  EXPECT_NE(refusal([](LoopMemory& of) { of.identity.machine = "belt"; }).find("belt"), std::string::npos);
  EXPECT_NE(refusal([](LoopMemory& of) { of.identity.program = "0"; }).find("program"), std::string::npos);
  EXPECT_NE(refusal([](LoopMemory& of) { of.layer = 8; }).find("layer 8"), std::string::npos);
  EXPECT_NE(refusal([](LoopMemory& of) { of.heights.estimates.pop_back(); }).find("119 cells"),
            std::string::npos);
}

TEST(LoopRun, ReadsItsMemoryStrictly) {
  const SensedWallCase wall = keptWall();
  const std::string kept = toYaml(memoryAfter(sensedWall(wall), wall.settings, 3));
  const auto refusal = [](const std::string& yaml) {
    try {
      memoryFromYaml(yaml, "kept.yaml");
    } catch (const InvalidConfig& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(kept), "");
  EXPECT_NE(refusal("a: 1\n").find("kept.yaml"), std::string::npos);
  EXPECT_NE(refusal(kept + "other: 1\n").find("other"), std::string::npos);
  EXPECT_NE(refusal(kept.substr(0, kept.size() / 2)), "");
  std::string fewer = kept;
  fewer.erase(fewer.find(',', fewer.find("error_mm: ")), 2);
  EXPECT_NE(refusal(fewer), "");
}

TEST(LoopRun, LearnsWithoutCorrecting) {
  SensedWallCase wall = wallCase();
  wall.settings.request = LoopRequest::Identify;
  const SensedWall printed = sensedWall(wall);
  for (const CorrectionMap& map : printed.maps) EXPECT_TRUE(map.paths.empty());
  EXPECT_NEAR(printed.layers.back().figures.gain_mean, 1.0 - 0.1 * (1.0 - std::pow(0.7, 8)), 0.005);
  EXPECT_NEAR(printed.layers.back().figures.mean_error_mm, 8 * 0.15, 0.01);
}

/// From the sixth layer on the wall is found nearly a layer too low.
TEST(LoopRun, HoldsBeforeTheNextLayerWhenAPieceComesOff) {
  SensedWallCase wall = wallCase();
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  bool is_held = false;
  std::size_t cloud = 0;
  for (const StampedTip& pose : printed.tips) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= pose.stamp_ns; ++cloud) {
      SensedCloud seen = printed.clouds[cloud];
      if (run.place().layer >= 5)
        for (Point3& point : seen.profiles[0]) point.z() += 1.4;  // farther from the sensor
      run.see(std::move(seen));
    }
    run.observe(pose);
    for (const RaisedAlarm& alarm : run.takeNews().alarms)
      if (alarm.alarm == LoopAlarm::Step) {
        is_held = true;
        EXPECT_EQ(alarm.reaction, LoopReaction::Hold);
        EXPECT_EQ(run.place().layer, 6U) << "the layer after it is not begun";
      }
  }
  EXPECT_TRUE(is_held);
}

/// Growth by the speed to the power -0.3, which may change by 1 %: cells of a layer differ by 0.6 % at most,
/// whatever the wave asks for, and the loop knows.
TEST(LoopRun, KnowsWhatTheLimitsOfSpeedLeaveOfACorrection) {
  SensedWallCase wall = wallCase();
  wall.settings.loop.speed_exponent = -0.3;
  wall.settings.loop.greatest_speed_mm_s = 30.0;
  wall.settings.loop.heat = 0.01;
  wall.grows = [](std::size_t, double along_mm) { return 1.0 + 0.1 * std::sin(0.2 * along_mm); };
  const LayerOutcome layer = sensedWall(wall).layers.at(3);
  EXPECT_GT(layer.figures.limited_share, 0.5);
  const auto [least, greatest] =
      std::minmax_element(layer.cells.begin(), layer.cells.end(),
                          [](const CellOutcome& a, const CellOutcome& b) { return a.amount < b.amount; });
  EXPECT_GT(least->amount, 0.0) << "the wire brings the mean";
  EXPECT_NEAR((1.0 + greatest->amount) / (1.0 + least->amount), std::pow(1.01 / 0.99, 0.3), 1e-4);
}

/// A print turned about the origin of its part, 100 mm above the bed, as a machine with inclined layers has
/// it.
SensedWall turned(SensedWall printed, const Eigen::Quaterniond& turn) {
  Eigen::Isometry3d bed_from_level = Eigen::Isometry3d::Identity();
  bed_from_level.translate(Eigen::Vector3d(0.0, 0.0, 100.0)).rotate(turn);
  printed.part.bed_from_part.translation() = Point3(0.0, 0.0, 100.0);
  printed.part.toolpath.part_from_layers = turn;
  for (ToolpathLayer& layer : printed.part.toolpath.layers)
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point = turn * point;
  for (StampedTip& pose : printed.tips) pose.tip = bed_from_level * pose.tip;
  for (SensedCloud& cloud : printed.clouds) cloud.bed_from_sensor = bed_from_level * cloud.bed_from_sensor;
  return printed;
}

/// Layers at 45 degrees, leaning to the side and along the bead, as of a belt: measured, corrected and learnt
/// from as the level ones.
TEST(LoopRun, CorrectsInclinedLayersAsLevelOnes) {
  SensedWallCase wall = wallCase();
  wall.grows = [](std::size_t, double along_mm) { return 1.0 + 0.05 * std::sin(0.2 * along_mm); };
  const SensedWall level = sensedWall(wall);
  EXPECT_GT(std::abs(correctionAt(level.maps.back().paths.at(0), 30.0).amount), 0.05);
  std::vector<std::size_t> order(level.tips.size() + level.clouds.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return stampOf(level, a) < stampOf(level, b); });
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0)}) {
    const SensedWall inclined = turned(level, Eigen::Quaterniond(Eigen::AngleAxisd(0.25 * M_PI, axis)));
    const auto maps = mapsOf(inclined, wall.settings, order);
    ASSERT_EQ(maps.size(), level.maps.size());
    for (std::size_t k = 2; k < maps.size(); ++k)
      for (const double along_mm : {5.0, 30.0, 55.0})
        EXPECT_NEAR(correctionAt(maps[k].paths.at(0), along_mm).amount,
                    correctionAt(level.maps[k].paths.at(0), along_mm).amount, 5e-3)
            << "layer " << k << " at " << along_mm << " mm";
  }
}

}  // namespace
}  // namespace lamina
