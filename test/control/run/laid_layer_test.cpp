// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/laid_layer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kTolerance = 1e-12;

/// A loop at the start of its first layer: a bead 1.5 mm high, in 40 cells.
HeightLoop begunLoop() {
  HeightLoop loop(LoopSettings{});
  loop.beginLayer(test::straightBeads({0.0}, 60.0, 1.5));
  return loop;
}

/// That bead over a layer whose nozzle was 0.5 mm too high: a fifth of the layer's height, 0.3 mm, is taken
/// back.
LaidLayer layerOverAShiftedOne(const HeightLoop& loop) {
  LaidLayer layer;
  layer.carryOver(0.0, 0.5);
  layer.decide(loop, LoopState::Off, LoopRunSettings{});
  return layer;
}

TEST(LaidLayer, TakesAShiftBackByAFifthOfALayer) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  ASSERT_EQ(layer.shift().size(), 40U);
  EXPECT_NEAR(layer.shift().front(), 0.2, kTolerance);
  EXPECT_NEAR(layer.shift().back(), 0.2, kTolerance);
  EXPECT_FALSE(layer.isAsPlanned());
  layer.decide(loop, LoopState::Off, LoopRunSettings{});
  EXPECT_NEAR(layer.meanShift(), 0.0, kTolerance);
  EXPECT_TRUE(layer.map(loop.cells(), "wall", 0).paths.empty());
}

TEST(LaidLayer, IsAsPlannedOnCellsThatMissedItsMap) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  layer.layMapFrom(loop.cells(), 10, LoopSettings{});
  EXPECT_TRUE(layer.isMapMissed());
  EXPECT_EQ(layer.shift()[9], 0.0);
  EXPECT_NEAR(layer.shift()[10], 0.2, kTolerance);
  EXPECT_NEAR(layer.meanShift(), 0.15, kTolerance);  // 0.2 mm on 30 of 40 cells
  EXPECT_EQ(layer.state(), LoopState::Off);
}

TEST(LaidLayer, CoastsIfAllCellsMissedItsMap) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  layer.layMapFrom(loop.cells(), 40, LoopSettings{});
  EXPECT_EQ(layer.state(), LoopState::Coasting);
  EXPECT_TRUE(layer.isAsPlanned());
}

/// 0.5 /s at 10 mm/s are 0.075 a cell of 1.5 mm.
TEST(LaidLayer, FadesOnCellsThatMissedItsMapAndGoesOverToIt) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer;
  layer.carryOver(0.2, 0.0);
  layer.decide(loop, LoopState::Off, LoopRunSettings{});
  layer.trim(loop.cells(), std::vector<double>(40, -0.1), LoopSettings{});
  layer.layMapFrom(loop.cells(), 10, LoopSettings{});
  const std::vector<double>& amount = layer.correction().amount;
  EXPECT_NEAR(amount[0], 0.125, kTolerance);
  EXPECT_NEAR(amount[1], 0.05, kTolerance);
  EXPECT_EQ(amount[2], 0.0);
  EXPECT_EQ(amount[9], 0.0);
  EXPECT_NEAR(amount[10], -0.075, kTolerance);
  EXPECT_NEAR(amount[11], -0.1, kTolerance);
  layer.layMapFrom(loop.cells(), 40, LoopSettings{});
  EXPECT_TRUE(layer.isWhollyMissed());
  EXPECT_NEAR(amount[1], 0.05, kTolerance);
  EXPECT_EQ(amount[39], 0.0);
  EXPECT_EQ(layer.lastAmount(), 0.0);
}

/// A bead of 60 mm and the support behind it, which is as planned: nothing is left to fade.
TEST(LaidLayer, CarriesNothingOverBehindSupport) {
  ToolpathLayer beads = test::straightBeadLayer({0.0, 3.0}, 60.0);
  beads.paths[2].role = PathRole::Support;
  HeightLoop loop(LoopSettings{});
  loop.beginLayer(layerCells(beads, 0, 1.5));
  LaidLayer layer;
  layer.decide(loop, LoopState::Off, LoopRunSettings{});
  layer.trim(loop.cells(), std::vector<double>(40, 0.2), LoopSettings{});
  EXPECT_EQ(layer.lastAmount(), 0.0);
  layer.decide(loop, LoopState::Off, LoopRunSettings{});
  layer.layMapFrom(loop.cells(), 40, LoopSettings{});
  EXPECT_EQ(layer.correction().amount[0], 0.0);
}

TEST(LaidLayer, HasItsMapAgainIfItTurnsOutThatNoneMissedIt) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  layer.layMapFrom(loop.cells(), 40, LoopSettings{});
  layer.layMapFrom(loop.cells(), 0, LoopSettings{});
  EXPECT_FALSE(layer.isMapMissed());
  EXPECT_EQ(layer.state(), LoopState::Off);
  EXPECT_NEAR(layer.shift().front(), 0.2, kTolerance);
}

TEST(LaidLayer, LosesItsMapIfLaidAsPlanned) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  layer.layAsPlanned(loop.cells(), LoopSettings{});
  EXPECT_EQ(layer.state(), LoopState::Coasting);
  EXPECT_EQ(layer.meanShift(), 0.0);
  EXPECT_TRUE(layer.map(loop.cells(), "wall", 0).paths.empty());
}

TEST(LaidLayer, KeepsItsShiftAsItIsTrimmed) {
  const HeightLoop loop = begunLoop();
  LaidLayer layer = layerOverAShiftedOne(loop);
  layer.trim(loop.cells(), std::vector<double>(40, 0.1), LoopSettings{});
  EXPECT_EQ(layer.lastAmount(), 0.1);
  const CorrectionMap map = layer.map(loop.cells(), "wall", 1);
  ASSERT_EQ(map.paths.size(), 1U);
  EXPECT_EQ(map.sequence, 1U);
  EXPECT_EQ(map.paths[0].stations[5].amount, 0.1);
  EXPECT_NEAR(map.paths[0].stations[5].dz_mm, 0.2, kTolerance);
}

}  // namespace
}  // namespace lamina
