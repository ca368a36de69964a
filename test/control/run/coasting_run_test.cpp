// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "lamina/control/run/loop_run.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::SensedWallCase;

constexpr std::size_t kLateLayer = 6;

SensedWallCase wallWithLateMaps(std::size_t first, std::size_t end) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = end + 2;
  wall.misses_map = [first, end](std::size_t layer) { return layer >= first && layer < end; };
  return wall;
}

/// Each comes with the map of the layer below, by the gain that is learnt by then: that of the layer below
/// that one.
TEST(CoastingRun, GivesEachLayerAMapByItsGainAheadOfItsOwn) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  const SensedWall printed = sensedWall(wall);
  const test::WallTruth truth = test::wallTruth(wall);
  ASSERT_EQ(printed.coasting_maps.size(), wall.layers - 1);
  for (const CorrectionMap& map : printed.coasting_maps) {
    EXPECT_TRUE(isCoasting(map));
    EXPECT_NO_THROW(validate(map));
    if (map.layer < 2) continue;  // the first layers are not corrected
    EXPECT_NEAR(correctionAt(map.paths.at(0), 30.0).amount, 1.0 / truth.gain[map.layer - 2] - 1.0, 0.01)
        << map.layer;
  }
  for (const CorrectionMap& map : printed.maps) EXPECT_EQ(map.sequence, 1U);
}

/// Half of the error is corrected by each layer: what the layer under way leaves of it is half of what it
/// found.
TEST(CoastingRun, SaysWithWhatTheNextLayerBeginsWhereAFeederIsLate) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  for (const CorrectionMap& map : sensedWall(wall).maps) EXPECT_TRUE(map.ahead.amount.empty()) << map.layer;
  wall.settings.loop.dead_time_s = 1.0;
  const SensedWall printed = sensedWall(wall);
  const test::WallTruth truth = test::wallTruth(wall);
  const auto first = static_cast<std::size_t>(wall.settings.loop.first_layers);
  ASSERT_EQ(printed.maps.size(), wall.layers);
  for (const CorrectionMap& map : printed.maps) {
    if (map.layer < first) continue;
    if (map.layer + 1 == wall.layers) {
      EXPECT_TRUE(map.ahead.amount.empty()) << "there is no layer above";
      continue;
    }
    const double left_mm = 0.5 * truth.error_mm[map.layer - 1];
    const double expected = (1.0 + 0.5 * left_mm / wall.layer_mm) / truth.gain[map.layer - 1] - 1.0;
    EXPECT_NEAR(map.ahead.interval_s * static_cast<double>(map.ahead.amount.size() - 1), 1.0, 1e-9);
    for (const double amount : map.ahead.amount) EXPECT_NEAR(amount, expected, 0.01) << map.layer;
  }
}

TEST(CoastingRun, GivesNoneWhereTheLoopCorrectsNothing) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.settings.request = LoopRequest::Identify;
  EXPECT_TRUE(sensedWall(wall).coasting_maps.empty());
}

/// Growth is learnt from what was laid: had the layer been taken for planned, it would show as a greater
/// gain.
TEST(CoastingRun, LearnsFromALayerThatIsLaidByItsCoastingMap) {
  SensedWallCase wall = wallWithLateMaps(kLateLayer, kLateLayer + 1);
  wall.takes_coasting_maps = true;
  for (const bool is_told_early : {false, true}) {
    wall.is_miss_told_early = is_told_early;
    const SensedWall printed = sensedWall(wall);
    const std::vector<double> gain = test::wallTruth(wall).gain;
    for (std::size_t k = 0; k < wall.layers; ++k)
      EXPECT_NEAR(printed.layers[k].figures.gain_mean, gain[k], 0.003) << k;
    const LayerOutcome& late = printed.layers[kLateLayer];
    EXPECT_EQ(late.state, LoopState::Coasting);
    const CorrectionMap& coasting = printed.coasting_maps[kLateLayer - 1];
    EXPECT_EQ(coasting.layer, kLateLayer);
    EXPECT_EQ(late.cells[60].amount, coasting.paths.at(0).stations[60].amount);
    double last = printed.layers[kLateLayer - 1].cells.back().amount;
    for (const CellOutcome& cell : late.cells) {
      EXPECT_LE(std::abs(cell.amount - last), 0.0125 + 1e-12) << "0.5 /s at 20 mm/s";
      last = cell.amount;
    }
    std::string reason;
    for (const RaisedAlarm& alarm : printed.alarms)
      if (alarm.alarm == LoopAlarm::MapLate) reason = alarm.reason;
    EXPECT_EQ(reason, "layer 6 is deposited by its coasting map, not by its map: none came within 2.5 s");
  }
}

/// Begun by its coasting map, the rest by its own: the last word of the machine is of that alone.
TEST(CoastingRun, LearnsFromAMapThatTookThePlaceOfTheCoastingOne) {
  SensedWallCase wall = wallWithLateMaps(kLateLayer, kLateLayer + 1);
  wall.takes_coasting_maps = true;
  wall.missed_mm = 20.0;
  const SensedWall printed = sensedWall(wall);
  const LayerOutcome& late = printed.layers[kLateLayer];
  EXPECT_EQ(late.state, LoopState::Active);
  EXPECT_EQ(late.cells[30].amount, printed.coasting_maps[kLateLayer - 1].paths[0].stations[30].amount);
  EXPECT_EQ(late.cells[100].amount, printed.maps[kLateLayer].paths[0].stations[100].amount);
  EXPECT_NEAR(late.figures.gain_mean, test::wallTruth(wall).gain[kLateLayer], 0.003);
}

/// Ten maps in a row that come too late, of a feeder at nine tenths.
TEST(CoastingRun, HoldsTheHeightWhereMapsComeTooLate) {
  SensedWallCase wall = wallWithLateMaps(10, 20);
  const auto errorAfterThem = [&](bool takes_coasting_maps) {
    wall.takes_coasting_maps = takes_coasting_maps;
    return sensedWall(wall).layers[19].figures.rmse_mm;
  };
  const double coasting_mm = errorAfterThem(true);
  const double planned_mm = errorAfterThem(false);
  std::printf("rmse after ten late maps: %.3f mm by coasting maps, %.3f mm as planned\n", coasting_mm,
              planned_mm);
  EXPECT_LT(coasting_mm, 0.1 * planned_mm);
  EXPECT_GT(planned_mm, 1.0) << "ten times a tenth of 1.5 mm, less what fades";
}

}  // namespace
}  // namespace lamina
