// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Print after print with everything going wrong at random. LAMINA_SIMULATED_HOURS=24 is the long form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "lamina/base/random.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::SensedWallCase;
using test::SensorDoes;

constexpr double kUsualHours = 0.25;
constexpr double kHighestPlanned = 1.3;  // layers planned anew, in heights of those before

double hoursAskedFor() {
  const char* const text = std::getenv("LAMINA_SIMULATED_HOURS");
  return text != nullptr ? std::strtod(text, nullptr) : kUsualHours;
}

/// A number below one that a fault of a layer has, the same each time it is asked for.
double chance(std::uint64_t print, std::size_t layer, std::uint64_t fault) {
  return Random(print * 1'000'003U + layer * 101U + fault).uniform(0.0, 1.0);
}

void failSensor(SensedWallCase& wall, std::uint64_t print) {
  wall.sensor = [print](std::size_t layer) {
    const double drawn = chance(print, layer, 1);
    return drawn < 0.6 ? SensorDoes::Measure : static_cast<SensorDoes>(1 + int((drawn - 0.6) / 0.4 * 6.999));
  };
}

void failProcess(SensedWallCase& wall, std::uint64_t print) {
  wall.grows = [print](std::size_t layer, double along_mm) {
    const double drawn = chance(print, layer, 2);
    const double clog = drawn < 0.05 ? 0.0 : (drawn < 0.1 ? 2.0 : 1.0);
    return clog * (1.0 + 0.1 * std::sin(along_mm / 10.0 + static_cast<double>(print)));
  };
  wall.befalls = [print](std::size_t layer, std::vector<double>& heights) {
    if (chance(print, layer, 3) > 0.08) return;
    const auto first =
        static_cast<std::size_t>(chance(print, layer, 4) * static_cast<double>(heights.size()));
    const double by_mm = 16.0 * (chance(print, layer, 5) - 0.5);
    for (std::size_t i = first; i < std::min(first + 15, heights.size()); ++i) heights[i] += by_mm;
  };
}

void meddle(SensedWallCase& wall, std::uint64_t print) {
  wall.misses_map = [print](std::size_t layer) { return chance(print, layer, 6) < 0.05; };
  wall.operates = [print](std::size_t layer, LoopRun& run) {
    if (chance(print, layer, 7) > 0.1) return;
    run.request(static_cast<LoopRequest>(int(chance(print, layer, 8) * 2.999)));
  };
}

SensedWallCase anyPrint(std::uint64_t print) {
  Random random(print);
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  LoopSettings& loop = wall.settings.loop;
  loop.z = static_cast<NozzleHeight>(print % 3);
  loop.on_loss = print % 2 == 0 ? LossOfSight::Hold : LossOfSight::Open;
  loop.silence_s = 0.5;
  loop.replan = static_cast<Replanning>(print % 4);
  wall.follows_plans = print % 3 != 0;
  wall.layers = 10 + print % 40;
  wall.length_mm = std::floor(random.uniform(20.0, 80.0));
  wall.growth = random.uniform(0.6, 1.4);
  wall.scans = print % 4 == 0 ? 3 : 1;
  wall.lag_s = random.uniform(-0.2, 0.2);
  wall.seed = print;
  failSensor(wall, print);
  failProcess(wall, print);
  meddle(wall, print);
  return wall;
}

/// The first thing that a map commands and may not; empty if there is none.
std::string wrongIn(const CorrectionMap& map, const SensedWallCase& wall) {
  const LoopSettings& loop = wall.settings.loop;
  const double steepest = loop.feeder_rate_s / wall.speed_mm_s;
  for (const PathCorrection& path : map.paths) {
    double last = path.stations.front().amount;
    double mean = 0.0;
    for (const PointCorrection& place : path.stations) {
      if (!std::isfinite(place.amount) || !std::isfinite(place.dz_mm)) return "a value that is no number";
      if (place.amount < loop.least_amount || place.amount > loop.greatest_amount)
        return "an amount of " + std::to_string(place.amount);
      if (std::abs(place.amount - last) > steepest * path.spacing_mm * (1.0 + 1e-9))
        return "a step of " + std::to_string(place.amount - last);
      if (std::abs(place.dz_mm) > kHighestPlanned * wall.layer_mm * (1.0 + 1e-9))
        return "a shift of " + std::to_string(place.dz_mm) + " mm";
      last = place.amount;
      mean += place.amount / static_cast<double>(path.stations.size());
    }
    if (std::abs(mean) > loop.layer_volume + 1e-9) return "a change of volume of " + std::to_string(mean);
  }
  return {};
}

double hoursOf(const SensedWall& printed) {
  return static_cast<double>(printed.tips.back().stamp_ns - printed.tips.front().stamp_ns) / 3.6e12;
}

TEST(LongPrint, StaysWithinItsLimitsWhateverGoesWrong) {
  double hours = 0.0;
  std::size_t layers = 0;
  std::size_t alarms = 0;
  std::size_t plans = 0;
  std::uint64_t print = 0;
  for (; hours < hoursAskedFor() && !HasFailure(); ++print) {
    const SensedWallCase wall = anyPrint(print);
    const SensedWall printed = test::sensedWall(wall);
    SCOPED_TRACE("print " + std::to_string(print));
    ASSERT_GE(printed.maps.size(), printed.layers.size()) << "no layer is left without its map";
    for (const PrintPlan& plan : printed.plans) EXPECT_NO_THROW(validate(plan.part.toolpath));
    plans += printed.plans.size();
    for (const CorrectionMap& map : printed.maps)
      EXPECT_EQ(wrongIn(map, wall), "") << "in layer " << map.layer;
    EXPECT_EQ(printed.counts.clouds, printed.counts.clouds_read + printed.counts.clouds_late +
                                         printed.counts.clouds_stuck + printed.counts.clouds_waiting);
    EXPECT_EQ(printed.counts.points.received, printed.counts.points.accounted());
    for (const LayerOutcome& layer : printed.layers)
      EXPECT_TRUE(std::isfinite(layer.figures.rmse_mm)) << layer.figures.layer;
    for (const RaisedAlarm& alarm : printed.alarms)
      EXPECT_EQ(alarm.reason.find("has moved on its mount"), std::string::npos) << alarm.reason;
    hours += hoursOf(printed);
    layers += printed.layers.size();
    alarms += printed.alarms.size();
  }
  RecordProperty("prints", std::to_string(print));
  std::printf("%.2f h simulated: %lu prints, %zu layers, %zu alarms, %zu plans\n", hours,
              static_cast<unsigned long>(print), layers, alarms, plans);
}

}  // namespace
}  // namespace lamina
