// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/height_loop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

LayerCells layerOf(std::size_t k, const std::vector<double>& beads_y = {0.0}) {
  return layerCells(test::straightBeadLayer(beads_y, 30.0, 1.5 * static_cast<double>(k + 1)), k, 0.5);
}

void seeAll(HeightLoop& loop, double error_mm) {
  for (std::size_t i = 0; i < loop.cells().size(); ++i) loop.see(i, {error_mm, 6, 0.02});
  loop.endCloud();
}

/// Lays layers that all grow by that much of what is planned, and are seen.
HeightLoop loopAfter(const LoopSettings& settings, int layers, double growth) {
  HeightLoop loop(settings);
  for (int k = 0; k < layers; ++k) {
    loop.beginLayer(layerOf(static_cast<std::size_t>(k)));
    loop.lay(loop.correction(LoopState::Identifying));
    seeAll(loop, 1.5 * (1.0 - growth) * (k + 1));
    loop.endLayer();
  }
  return loop;
}

TEST(HeightLoop, CorrectsNothingWhileItIsNotActive) {
  HeightLoop loop = loopAfter({}, 5, 0.9);
  loop.beginLayer(layerOf(5));
  for (const LoopState state : {LoopState::Off, LoopState::Identifying, LoopState::Open, LoopState::Blocked})
    for (const double amount : loop.correction(state).amount) EXPECT_EQ(amount, 0.0);
  for (const double amount : loop.correction(LoopState::Active).amount) EXPECT_GT(amount, 0.1);
}

TEST(HeightLoop, CoastsByWhatItHasLearnt) {
  HeightLoop loop = loopAfter({}, 30, 0.9);
  loop.beginLayer(layerOf(30));
  for (const double amount : loop.correction(LoopState::Coasting).amount)
    EXPECT_NEAR(amount, 1.0 / 0.9 - 1.0, 2e-3);
}

TEST(HeightLoop, LearnsFirst) {
  HeightLoop loop((LoopSettings()));
  loop.beginLayer(layerOf(0));
  for (const double amount : loop.correction(LoopState::Active).amount) EXPECT_EQ(amount, 0.0);
  loop.lay(loop.correction(LoopState::Active));
  seeAll(loop, 0.15);
  const LayerFigures figures = loop.endLayer();
  EXPECT_TRUE(figures.is_measured);
  EXPECT_NEAR(figures.mean_error_mm, 0.15, 0.01);
  EXPECT_NEAR(figures.gain_mean, 1.0 - 0.3 * 0.1, 1e-3);
  loop.beginLayer(layerOf(1));
  for (const double amount : loop.correction(LoopState::Active).amount) EXPECT_EQ(amount, 0.0);
}

TEST(HeightLoop, CountsALayerThatIsHardlySeenAsUnmeasured) {
  HeightLoop loop((LoopSettings()));
  loop.beginLayer(layerOf(0));
  loop.lay(loop.correction(LoopState::Active));
  for (std::size_t i = 0; i < 29; ++i) loop.see(i, {0.15, 6, 0.02});
  loop.endCloud();
  const LayerFigures figures = loop.endLayer();
  EXPECT_NEAR(figures.coverage, 29.0 / 60.0, 1e-9);
  EXPECT_FALSE(figures.is_measured);
  EXPECT_EQ(figures.gain_mean, 1.0) << "nothing is learnt";
}

/// As if none had come: a sensor that is found to be stuck has shown the layer as high as planned.
TEST(HeightLoop, ForgetsWhatCloudsShowedOfALayer) {
  HeightLoop unseen = loopAfter({}, 5, 0.9);
  unseen.beginLayer(layerOf(5, {0.0, 3.0}));  // of the second bead nothing is below
  unseen.lay(unseen.correction(LoopState::Identifying));
  HeightLoop seen = unseen;
  for (const double error_mm : {0.85, 0.8, 0.0, 0.0, 0.0}) seeAll(seen, error_mm);
  EXPECT_GT(std::abs(seen.estimates()[0].error() - unseen.estimates()[0].error()), 0.02);
  seen.forgetClouds();
  const LayerFigures figures = seen.endLayer();
  const LayerFigures expected = unseen.endLayer();
  EXPECT_FALSE(figures.is_measured);
  EXPECT_EQ(figures.coverage, 0.0);
  EXPECT_EQ(figures.gain_mean, expected.gain_mean);
  EXPECT_EQ(figures.spread, expected.spread);
  for (std::size_t i = 0; i < seen.cells().size(); ++i) {
    const CellEstimate& cell = seen.estimates()[i];
    EXPECT_NEAR(cell.error(), unseen.estimates()[i].error(), 1e-6) << i;
    EXPECT_EQ(cell.isKnown(), unseen.estimates()[i].isKnown()) << i;
    EXPECT_FALSE(cell.contested()) << i;
  }
  unseen.beginLayer(layerOf(6, {0.0, 3.0}));
  seen.beginLayer(layerOf(6, {0.0, 3.0}));
  EXPECT_NEAR(seen.correction(LoopState::Active).amount[0], unseen.correction(LoopState::Active).amount[0],
              1e-6);
}

/// Of two beads side by side, one over nothing, the sensor sees the other alone, 0.2 mm too low.
TEST(HeightLoop, FindsTheErrorsOfTheCellsThatItSaw) {
  LoopSettings settings;
  settings.min_coverage = 0.4;
  settings.alarm_layers = 0.1;  // 0.15 mm
  HeightLoop loop = loopAfter(settings, 3, 1.0);
  loop.beginLayer(layerOf(3, {0.0, 50.0}));
  loop.lay(loop.correction(LoopState::Identifying));
  const std::size_t seen = loop.cells().runs[1].first;
  for (std::size_t i = 0; i < seen; ++i) loop.see(i, {0.2, 6, 0.02});
  loop.endCloud();
  const LayerFigures figures = loop.endLayer();
  EXPECT_TRUE(figures.is_measured);
  EXPECT_NEAR(figures.coverage, 0.5, 1e-12);
  EXPECT_NEAR(figures.mean_error_mm, 0.2, 0.01);
  EXPECT_NEAR(figures.rmse_mm, 0.2, 0.01);
  EXPECT_NEAR(figures.flatness_mm, 0.0, 0.01);
  EXPECT_NEAR(figures.deviating_share, 1.0, 1e-12);
}

TEST(HeightLoop, BelievesAPatchAsWideAsABeadAtOnce) {
  HeightLoop loop = loopAfter({}, 5, 1.0);
  loop.beginLayer(layerOf(5));
  loop.lay(loop.correction(LoopState::Identifying));
  for (std::size_t i = 0; i < loop.cells().size(); ++i)
    loop.see(i, {i >= 20 && i < 26 ? -1.5 : 0.0, 6, 0.02});  // a lump of 3 mm, a bead's width
  loop.see(40, {-1.5, 6, 0.02});
  loop.endCloud();
  EXPECT_NEAR(loop.estimates()[22].error(), -1.5, 1e-6);
  EXPECT_NEAR(loop.estimates()[40].error(), 0.0, 0.01) << "a single stray reading";
}

TEST(HeightLoop, TakesTheGainOfItsRegionWhereNothingIsBelow) {
  HeightLoop loop = loopAfter({}, 30, 0.8);
  loop.beginLayer(layerOf(30, {0.0, 50.0}));
  const LayerKnowledge known = loop.knowledge();
  const std::size_t beside = loop.cells().runs[1].first + 30;
  EXPECT_FALSE(loop.estimates()[beside].isKnown());
  EXPECT_NEAR(known.gain[beside], 0.8, 5e-3);
  EXPECT_NEAR(known.error_mm[beside], known.error_mm[30], 0.02) << "the mean of the layer below";
}

/// A bead beside the wall, over air, sags by 0.6 mm: it was fed as the wall was.
TEST(HeightLoop, LearnsNoGainFromASagOverNothing) {
  HeightLoop loop = loopAfter({}, 30, 1.0);
  loop.beginLayer(layerOf(30, {0.0, 50.0}));
  loop.lay(loop.correction(LoopState::Identifying));
  const CellRun run = loop.cells().runs[1];
  for (std::size_t i = 0; i < loop.cells().size(); ++i) loop.see(i, {i < run.first ? 0.0 : 0.6, 6, 0.02});
  loop.endCloud();
  const LayerFigures figures = loop.endLayer();
  EXPECT_NEAR(loop.estimates()[run.first + 30].error(), 0.6, 0.01);
  EXPECT_NEAR(figures.gain_least, 1.0, 5e-3);
  EXPECT_LT(figures.consistency, 0.1) << "a sag is no surprise of growth";
}

TEST(HeightLoop, RefusesReadingsOfNoCell) {
  HeightLoop loop((LoopSettings()));
  loop.beginLayer(layerOf(0));
  EXPECT_THROW(loop.see(60, {0.0, 6, 0.02}), InvalidInput);
  EXPECT_THROW(loop.seeDeficit(60, 0.1), InvalidInput);
  EXPECT_NO_THROW(loop.seeDeficit(59, 0.1)) << "nothing is deposited yet";
  LayerCorrection shorter;
  shorter.amount.assign(59, 0.0);
  EXPECT_THROW(loop.lay(shorter), InvalidInput);
  EXPECT_THROW(loop.lay(loop.correction(LoopState::Off), {0.0}), InvalidInput);
}

TEST(HeightLoop, ContestsReadingsOfNoKnownNoise) {
  HeightLoop loop((LoopSettings()));
  loop.beginLayer(layerOf(0));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(loop.see(3, {0.0, 6, infinity}).use, ReadingUse::Contested);
  EXPECT_EQ(loop.see(3, {0.0, 6, std::nan("")}).use, ReadingUse::Contested);
  EXPECT_EQ(loop.endLayer().coverage, 0.0);
}

CellReading anyReading() {
  const double specials[] = {std::nan(""), std::numeric_limits<double>::infinity(), 1e300, -1e300, 0.0};
  const double error =
      *rc::gen::arbitrary<bool>() ? 0.01 * *rc::gen::inRange(-300, 300) : specials[*rc::gen::inRange(0, 5)];
  return {error, *rc::gen::inRange(-1, 50), 0.001 * *rc::gen::inRange(0, 100)};
}

void seeAnyCloud(HeightLoop& loop) {
  const int readings = *rc::gen::inRange(0, 60);
  for (int r = 0; r < readings; ++r)
    loop.see(*rc::gen::inRange<std::size_t>(0, loop.cells().size()), anyReading());
  loop.endCloud();
}

TEST(HeightLoop, IsMovedByNoSingleCloudByMoreThanATenth) {
  const LoopSettings settings;
  EXPECT_TRUE(rc::check("whatever the cloud", [&] {
    HeightLoop loop = loopAfter(settings, 4, 0.7 + 0.01 * *rc::gen::inRange(0, 60));
    loop.beginLayer(layerOf(4));
    loop.lay(loop.correction(LoopState::Active));
    HeightLoop unseen = loop;
    seeAnyCloud(loop);
    loop.endLayer();
    unseen.endLayer();
    loop.beginLayer(layerOf(5));
    unseen.beginLayer(layerOf(5));
    for (const LoopState state : {LoopState::Active, LoopState::Coasting}) {
      const auto with = loop.correction(state).amount;
      const auto without = unseen.correction(state).amount;
      for (std::size_t i = 0; i < with.size(); ++i) {
        RC_ASSERT(std::isfinite(with[i]));
        RC_ASSERT(with[i] >= settings.least_amount && with[i] <= settings.greatest_amount);
        RC_ASSERT(std::abs(with[i] - without[i]) <= 0.1 * amountRange(settings) + 1e-12);
      }
    }
  }));
}

TEST(HeightLoop, IsMovedByNoSingleCloudByMoreThanATenthOfAPressedAmount) {
  LoopSettings settings;
  settings.process = LoopProcess::Pressed;
  HeightLoop loop = loopAfter(settings, 4, 1.0);
  loop.beginLayer(layerOf(4));
  loop.lay(loop.correction(LoopState::Active));
  for (std::size_t i = 0; i < loop.cells().size(); ++i) loop.seeDeficit(i, 0.9);
  loop.endCloud();
  loop.endLayer();
  loop.beginLayer(layerOf(5));
  for (const double amount : loop.correction(LoopState::Active).amount) EXPECT_NEAR(amount, 0.1 * 0.3, 1e-9);
}

TEST(HeightLoop, StaysWithinItsLimitsWhateverItSees) {
  const LoopSettings settings;
  EXPECT_TRUE(rc::check("layers of any clouds", [&] {
    HeightLoop loop(settings);
    for (std::size_t k = 0; k < 6; ++k) {
      loop.beginLayer(layerOf(k));
      const LayerCorrection correction = loop.correction(LoopState::Active);
      for (std::size_t i = 0; i < correction.amount.size(); ++i) {
        RC_ASSERT(correction.amount[i] >= settings.least_amount &&
                  correction.amount[i] <= settings.greatest_amount);
        const double step = greatestSlope(settings.feeder_rate_s, 10.0) * 0.5;
        // In brackets of its own: what RC_ASSERT takes apart is evaluated whole.
        RC_ASSERT((i == 0 || std::abs(correction.amount[i] - correction.amount[i - 1]) <= step + 1e-12));
      }
      loop.lay(correction);
      seeAnyCloud(loop);
      seeAnyCloud(loop);
      const LayerFigures figures = loop.endLayer();
      RC_ASSERT(std::isfinite(figures.rmse_mm) && std::isfinite(figures.gain_mean));
    }
  }));
}

/// Ten thousand clouds of anything, empty ones too, over a print of a hundred layers.
TEST(HeightLoop, TakesTenThousandCloudsOfAnything) {
  const LoopSettings settings;
  const double specials[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 0.0};
  HeightLoop loop(settings);
  Random random(3);
  for (std::size_t k = 0; k < 100; ++k) {
    loop.beginLayer(layerOf(k));
    const LayerCorrection correction = loop.correction(LoopState::Active);
    for (const double amount : correction.amount)
      ASSERT_TRUE(amount >= settings.least_amount && amount <= settings.greatest_amount);
    loop.lay(correction);
    for (int cloud = 0; cloud < 100; ++cloud) {
      for (std::uint64_t r = random.below(20); r > 0; --r) {
        const double error = random.below(3) == 0 ? specials[random.below(4)] : random.normal(0.0, 1.0);
        loop.see(random.below(loop.cells().size()), {error, static_cast<int>(random.below(9)), 0.02});
      }
      loop.endCloud();
    }
    ASSERT_TRUE(std::isfinite(loop.endLayer().rmse_mm));
  }
}

/// Leaving a state amid a layer: the amounts in force fade to those of the next state within the slope.
TEST(HeightLoop, LeavesAStateWithoutAStep) {
  const LoopSettings settings;
  HeightLoop loop = loopAfter(settings, 6, 0.8);
  loop.beginLayer(layerOf(6));
  const auto active = loop.correction(LoopState::Active).amount;
  for (const LoopState next : {LoopState::Off, LoopState::Open, LoopState::Coasting}) {
    const auto target = loop.correction(next).amount;
    const auto faded = fadedCorrection(loop.cells(), active, target, 20, settings);
    const double step = greatestSlope(settings.feeder_rate_s, 10.0) * 0.5;
    for (std::size_t i = 1; i < faded.size(); ++i) EXPECT_LE(std::abs(faded[i] - faded[i - 1]), step + 1e-12);
    EXPECT_EQ(faded[19], active[19]);
    EXPECT_EQ(faded.back(), target.back());
  }
}

}  // namespace
}  // namespace lamina
