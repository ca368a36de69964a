// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/part_learning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/deposition/growth_plant.hpp"
#include "support/printed_wall.hpp"

namespace lamina {
namespace {

const PartIdentity kPart{"4f2a", "gantry_45", "wire"};
constexpr std::size_t kLayerCount = 10;
constexpr double kLearntLayer = 1.5;

LayerCells wallCells(std::size_t layer) {
  Path path;
  path.role = PathRole::OuterWall;
  path.bead = Bead{3.0, kLearntLayer};
  path.feed_mm_s = 10.0;
  const double z = kLearntLayer * static_cast<double>(layer + 1);
  path.points = {{0, 0, z}, {100, 0, z}};
  return layerCells({z, kLearntLayer, {path}}, layer, 0.5);
}

struct DepositedPart {
  std::vector<DepositedLayer> layers;
  double rmse_mm = 0.0;  ///< of the heights of all layers
};

/// The part deposited by a disturbed process as the map says, the loop off.
DepositedPart depositedPart(const PartMap& map, int seed) {
  PlantSettings settings = test::disturbedPlant();
  settings.levelling_mm = 0.0;
  settings.random = 0.005;
  settings.seed = seed;
  const GrowthPlant plant(settings);
  DepositedPart part;
  std::vector<double> heights;
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < kLayerCount; ++k) {
    DepositedLayer layer{wallCells(k), {}, {}};
    const std::size_t cells = layer.cells.size();
    layer.amount = map.parts > 0 ? map.amount[k] : std::vector<double>(cells, 0.0);
    if (k == 0) heights.assign(cells, 0.0);
    PlantBead bead;
    bead.layer = k;
    bead.layers = kLayerCount;
    bead.length_mm = 100.0;
    bead.along_mm = layer.cells.along_mm;
    bead.planned_mm = layer.cells.height_mm;
    bead.correction = layer.amount;
    bead.nozzle_far_mm.assign(cells, 0.0);
    const std::vector<double> before = heights;
    heights = plant.afterBead(bead, heights);
    for (std::size_t i = 0; i < cells; ++i) {
      layer.growth_error_mm.push_back(kLearntLayer - (heights[i] - before[i]));
      const double error = kLearntLayer * static_cast<double>(k + 1) - heights[i];
      squares += error * error;
      count += 1.0;
    }
    part.layers.push_back(std::move(layer));
  }
  part.rmse_mm = std::sqrt(squares / count);
  return part;
}

TEST(PartLearning, GetsBetterFromPartToPart) {
  PartMap map;
  std::vector<double> rmse;
  for (int print = 1; print <= 5; ++print) {
    const DepositedPart part = depositedPart(map, print);
    rmse.push_back(part.rmse_mm);
    map = learntFromPart(map, kPart, part.layers, PartEnd::Complete, LoopSettings());
    EXPECT_TRUE(print == 1 || rmse.back() < rmse[rmse.size() - 2]) << "print " << print;
  }
  EXPECT_LT(rmse.back(), 0.5 * rmse.front());
  EXPECT_EQ(map.parts, 5U);
}

/// Cells that grow by a share of what is commanded, over errors that the loop mends meanwhile.
DepositedLayer evenLayer(double gain, double amount) {
  DepositedLayer layer{wallCells(0), {}, {}};
  layer.amount.assign(layer.cells.size(), amount);
  layer.growth_error_mm.assign(layer.cells.size(), kLearntLayer * (1.0 - gain * (1.0 + amount)));
  return layer;
}

/// Growth of 0.9 asks for 1 / 0.9 - 1 = 1 / 9, whatever was deposited beyond the map to mend what lay below.
/// Of the first part all of it is learnt, of the second a half of what is missing.
TEST(PartLearning, LearnsWhatMakesACellGrowAsPlanned) {
  for (const double mended : {0.0, 0.1, -0.2}) {
    const PartMap first =
        learntFromPart({}, kPart, {evenLayer(0.9, mended)}, PartEnd::Complete, LoopSettings());
    for (const double amount : first.amount[0]) EXPECT_NEAR(amount, 1.0 / 9.0, 1e-12) << mended;
    const PartMap second =
        learntFromPart(first, kPart, {evenLayer(1.0, 0.1 + mended)}, PartEnd::Complete, LoopSettings());
    for (const double amount : second.amount[0]) EXPECT_NEAR(amount, 1.0 / 18.0, 1e-12) << mended;
  }
}

TEST(PartLearning, LearnsNothingOfCellsThatWereNotSeen) {
  const PartMap first = learntFromPart({}, kPart, {evenLayer(0.9, 0.0)}, PartEnd::Complete, LoopSettings());
  DepositedLayer unseen = evenLayer(1.0, 0.1);
  unseen.growth_error_mm.assign(unseen.cells.size(), std::numeric_limits<double>::quiet_NaN());
  const PartMap second = learntFromPart(first, kPart, {unseen}, PartEnd::Complete, LoopSettings());
  EXPECT_EQ(second.amount, first.amount);
}

TEST(PartLearning, LearnsNothingFromAnAbortedPart) {
  const DepositedPart part = depositedPart({}, 1);
  const PartMap map = learntFromPart({}, kPart, part.layers, PartEnd::Complete, LoopSettings());
  const PartMap after = learntFromPart(map, kPart, part.layers, PartEnd::Aborted, LoopSettings());
  EXPECT_EQ(after.parts, 1U);
  EXPECT_EQ(after.amount, map.amount);
}

TEST(PartLearning, RefusesLayersWithoutAValuePerCell) {
  DepositedPart part = depositedPart({}, 1);
  part.layers[3].growth_error_mm.pop_back();
  EXPECT_THROW(learntFromPart({}, kPart, part.layers, PartEnd::Complete, LoopSettings()), InvalidInput);
}

TEST(PartLearning, RefusesAMapOfOtherCells) {
  const PartMap map = learntFromPart({}, kPart, {evenLayer(0.9, 0.0)}, PartEnd::Complete, LoopSettings());
  for (const std::ptrdiff_t more : {-1, 1, 1000}) {
    PartMap other = map;
    const std::size_t cells = map.amount[0].size();
    other.amount[0].resize(cells + static_cast<std::size_t>(more), 0.1);
    try {
      learntFromPart(other, kPart, {evenLayer(0.9, 0.0)}, PartEnd::Complete, LoopSettings());
      FAIL() << more;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("has " + std::to_string(cells) + " cells"), std::string::npos)
          << error.what();
    }
  }
}

TEST(PartLearning, RefusesAMapOfAnotherMachine) {
  const DepositedPart part = depositedPart({}, 1);
  const PartMap map = learntFromPart({}, kPart, part.layers, PartEnd::Complete, LoopSettings());
  PartIdentity other = kPart;
  other.machine = "irb_4600";
  EXPECT_EQ(differenceOf(kPart, other), "machine 'irb_4600' instead of 'gantry_45'");
  EXPECT_THROW(learntFromPart(map, other, part.layers, PartEnd::Complete, LoopSettings()), InvalidInput);
  std::vector<DepositedLayer> fewer(part.layers.begin(), part.layers.end() - 1);
  EXPECT_THROW(learntFromPart(map, kPart, fewer, PartEnd::Complete, LoopSettings()), InvalidInput);
  EXPECT_EQ(differenceOf(kPart, kPart), "");
}

}  // namespace
}  // namespace lamina
