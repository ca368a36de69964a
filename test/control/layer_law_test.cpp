// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/pressed_law.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-12;

LayerKnowledge evenly(const LayerCells& cells, double error_mm, double gain) {
  return {std::vector<double>(cells.size(), error_mm), std::vector<double>(cells.size(), gain)};
}

TEST(LayerLaw, CorrectsAShareOfTheErrorAndTheGain) {
  const LayerCells cells = test::straightBeads({0.0}, 30.0, 0.5);
  LoopSettings settings;
  settings.layer_volume = 1.0;
  const LayerCorrection law = freeCorrection(cells, evenly(cells, 0.15, 0.9), settings);
  for (const double amount : law.amount) EXPECT_NEAR(amount, (1.0 + 0.5 * 0.15 / 1.5) / 0.9 - 1.0, kRounding);
  EXPECT_EQ(law.limited_share, 0.0);
  for (const double amount : learntCorrection(cells, std::vector<double>(cells.size(), 0.9), settings).amount)
    EXPECT_NEAR(amount, 1.0 / 0.9 - 1.0, kRounding);
}

TEST(LayerLaw, KeepsTheAmountWithinItsLimitsAndSaysWhere) {
  const LayerCells cells = test::straightBeads({0.0}, 30.0, 0.5);
  LoopSettings settings;
  settings.layer_volume = 1.0;
  LayerKnowledge known = evenly(cells, 0.0, 1.0);
  for (std::size_t i = 0; i < 30; ++i) known.error_mm[i] = 30.0;
  settings.low_pass_mm = 0.01;
  settings.feeder_rate_s = 1000.0;
  const LayerCorrection law = freeCorrection(cells, known, settings);
  EXPECT_EQ(law.amount[10], 0.5);
  EXPECT_EQ(law.amount[50], 0.0);
  EXPECT_NEAR(law.limited_share, 0.5, 1e-9);
}

TEST(LayerLaw, KeepsTheVolumeOfALayer) {
  const LayerCells cells = test::straightBeads({0.0}, 30.0, 0.5);
  const LayerCorrection law = freeCorrection(cells, evenly(cells, 1.5, 1.0), LoopSettings());
  for (const double amount : law.amount) EXPECT_NEAR(amount, 0.2, kRounding);
  EXPECT_EQ(law.limited_share, 1.0);
}

/// Of cells that are all alike.
double meanOf(const std::vector<double>& amount) {
  return std::accumulate(amount.begin(), amount.end(), 0.0) / static_cast<double>(amount.size());
}

/// A peak on flat ground, at speeds at which the feeder cannot follow it: 12 of 80 cells ask for 0.5, all
/// others for 0.1. What the peak loses its surroundings get, and no more.
TEST(LayerLaw, KeepsTheVolumeWhereTheFeederCannotFollow) {
  LayerCells cells = test::straightBeads({0.0}, 40.0, 0.5);
  std::vector<double> wanted(cells.size(), 0.1);
  std::fill_n(wanted.begin() + 34, 12, 0.5);
  for (const double speed : {30.0, 60.0}) {
    cells.speed_mm_s.assign(cells.size(), speed);
    const LayerCorrection law = limitedCorrection(cells, wanted, LoopSettings());
    EXPECT_NEAR(meanOf(law.amount), (68.0 * 0.1 + 12.0 * 0.5) / 80.0, 1e-9) << speed;
    EXPECT_LT(law.amount.front(), 0.15) << speed;
    EXPECT_GT(law.amount[40], law.amount.front()) << speed;
    EXPECT_EQ(law.limited_share, 0.0);
  }
}

LayerKnowledge anyKnowledge(const LayerCells& cells) {
  LayerKnowledge known;
  const auto any = rc::gen::inRange(-3000, 3000);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    known.error_mm.push_back(0.001 * *any);
    known.gain.push_back(0.4 + 2.1 * 0.001 * *rc::gen::inRange(0, 1000));
  }
  return known;
}

void requireWithin(const LayerCells& cells, const std::vector<double>& amount, const LoopSettings& settings) {
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      RC_ASSERT(std::isfinite(amount[i]));
      RC_ASSERT(amount[i] >= settings.least_amount - kRounding &&
                amount[i] <= settings.greatest_amount + kRounding);
      const double step = greatestSlope(settings.feeder_rate_s, 10.0) * run.cellLength();
      if (i > run.first) RC_ASSERT(std::abs(amount[i] - amount[i - 1]) <= step + kRounding);
    }
    const double seam = std::abs(amount[run.first] - amount[run.first + run.count - 1]);
    const double step = greatestSlope(settings.feeder_rate_s, 10.0) * run.cellLength();
    if (run.is_closed) RC_ASSERT(seam <= step + kRounding);
  }
}

TEST(LayerLaw, StaysWithinAmountAndSlope) {
  EXPECT_TRUE(rc::check("whatever is known", [] {
    LayerCells cells = test::straightBeads({0.0, 3.0}, 10.0, 1.0);
    cells.runs[1].is_closed = *rc::gen::arbitrary<bool>();
    LoopSettings settings;
    settings.low_pass_mm = *rc::gen::element(0.01, 1.0, 3.0);
    const LayerCorrection law = freeCorrection(cells, anyKnowledge(cells), settings);
    requireWithin(cells, law.amount, settings);
    RC_ASSERT(std::abs(meanOf(law.amount)) <= settings.layer_volume + kRounding);
    requireWithin(cells, ledCorrection(cells, law.amount, {}, {0.3, 0.2}, settings), settings);
  }));
}

TEST(LayerLaw, AsksForNothingWhereANumberIsNone) {
  const LayerCells cells = test::straightBeads({0.0}, 10.0, 1.0);
  std::vector<double> wanted(cells.size(), std::nan(""));
  wanted[3] = std::numeric_limits<double>::infinity();
  for (const double amount : limitedCorrection(cells, wanted, LoopSettings()).amount) EXPECT_EQ(amount, 0.0);
}

TEST(LayerLaw, FadesNoFasterThanTheFeederFollows) {
  const LayerCells cells = test::straightBeads({0.0}, 20.0, 1.0);
  const std::vector<double> from(cells.size(), 0.3);
  const std::vector<double> to(cells.size(), 0.0);
  const auto faded = fadedCorrection(cells, from, to, 5, LoopSettings());
  EXPECT_EQ(faded[4], 0.3);
  EXPECT_NEAR(faded[5], 0.25, kRounding);  // 0.5 /s at 10 mm/s: 0.05 per mm
  EXPECT_NEAR(faded[9], 0.05, kRounding);
  EXPECT_EQ(faded[11], 0.0);
}

/// Two beads of ten cells of 1 mm: the second steps, as the map that was reached on the first one has it.
TEST(FadedCorrection, StepsFromPathToPathOnceTheMapIsReached) {
  const LayerCells cells = test::straightBeads({0.0, 3.0}, 10.0, 1.0);
  std::vector<double> to(20, 0.1);
  std::fill(to.begin() + 10, to.end(), -0.2);
  const auto faded = fadedCorrection(cells, std::vector<double>(20, 0.0), to, 5, LoopSettings());
  EXPECT_NEAR(faded[5], 0.05, kRounding);  // 0.5 /s at 10 mm/s: 0.05 per mm
  EXPECT_EQ(faded[6], 0.1);
  EXPECT_EQ(faded[10], -0.2);
  const auto late = fadedCorrection(cells, std::vector<double>(20, 0.0), to, 9, LoopSettings());
  EXPECT_NEAR(late[10], 0.0, kRounding) << "not reached on the first one";
  EXPECT_NEAR(late[11], -0.05, kRounding);
}

/// Support between two beads is as planned: what comes behind it is as the new map has it.
TEST(FadedCorrection, EndsWhereSomethingWithoutCellsIsDeposited) {
  ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0, 6.0}, 10.0);
  layer.paths[2].role = PathRole::Support;
  const LayerCells cells = layerCells(layer, 0, 1.0);
  ASSERT_EQ(cells.runs.size(), 2U);
  EXPECT_FALSE(cells.runs[0].is_after_other);
  EXPECT_TRUE(cells.runs[1].is_after_other);
  EXPECT_FALSE(cells.ends_with_other);
  const std::vector<double> before(20, 0.8);
  const auto faded = fadedCorrection(cells, before, std::vector<double>(20, 0.0), 0, LoopSettings());
  EXPECT_NEAR(faded[9], 0.3, kRounding);
  EXPECT_EQ(faded[10], 0.0);
  layer.paths[4].role = PathRole::Support;
  EXPECT_TRUE(layerCells(layer, 0, 1.0).ends_with_other);
}

TEST(FeederLead, CommandsWhatIsNeededWhereTheNozzleWillBe) {
  const LayerCells cells = test::straightBeads({0.0}, 100.0, 0.5);
  std::vector<double> amount;
  for (const double s : cells.along_mm) amount.push_back(0.1 * std::sin(2.0 * M_PI * s / 50.0));
  const auto led = ledCorrection(cells, amount, {}, {1.5, 0.0}, LoopSettings());
  for (std::size_t i = 0; i + 40 < cells.size(); ++i) EXPECT_NEAR(led[i], amount[i + 30], 1e-9);
  EXPECT_EQ(ledCorrection(cells, amount, {}, {}, LoopSettings()), amount);
}

/// 10 mm/s, a dead time of 1 s: the last 10 mm of a layer are commanded for the first 10 mm of the next one.
TEST(FeederLead, EndsWithWhatIsExpectedOfTheLayerAbove) {
  const LayerCells cells = test::straightBeads({0.0}, 100.0, 0.5);
  const std::vector<double> amount(cells.size(), 0.1);
  const ExpectedBeginning ahead{0.5, {0.12, 0.14}};  // at 0.25 s and 0.75 s, or 2.5 and 7.5 mm
  const auto led = ledCorrection(cells, amount, ahead, {1.0, 0.0}, LoopSettings());
  EXPECT_NEAR(led[0], 0.1, kRounding);
  EXPECT_NEAR(led[179], 0.1, kRounding);  // 89.75 mm
  EXPECT_NEAR(led[195], 0.14, 1e-6);      // 97.75 mm, beyond the last
  EXPECT_NEAR(led[187], 0.12 + 0.02 * (93.75 - 92.5) / 5.0, 1e-6);
  EXPECT_NEAR(led[199], 0.14, 1e-6);
}

TEST(FeederLead, SaysWhatALayerBeginsWith) {
  const LayerCells cells = test::straightBeads({0.0}, 100.0, 0.5);
  std::vector<double> amount;
  for (const double s : cells.along_mm) amount.push_back(0.001 * s);
  const ExpectedBeginning ahead = expectedBeginning(cells, amount, 1.0);
  EXPECT_DOUBLE_EQ(ahead.interval_s, 0.05);  // 20 cells of 0.5 mm at 10 mm/s
  ASSERT_EQ(ahead.amount.size(), 21U);
  EXPECT_NEAR(ahead.amount[0], 0.00025, 1e-12);
  EXPECT_NEAR(ahead.amount[20], 0.01025, 1e-12);
  EXPECT_TRUE(expectedBeginning(cells, amount, 0.0).amount.empty());
  EXPECT_EQ(expectedBeginning(cells, amount, 1000.0).amount.size(), 257U);
}

TEST(FeederLead, LeadsAMapByPlaces) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0}, 100.0);
  const LayerCells cells = layerCells(layer, 4, 0.5);
  CellCorrections corrections;
  for (const double s : cells.along_mm) corrections.amount.push_back(0.1 * std::sin(2.0 * M_PI * s / 50.0));
  corrections.dz_mm.assign(cells.size(), 0.25);
  CorrectionMap map = correctionMap(cells, corrections, "part", 3);
  EXPECT_EQ(digestOf(ledMap(map, layer, {}, LoopSettings())), digestOf(map)) << "no delay";
  const CorrectionMap led = ledMap(map, layer, {1.5, 0.0}, LoopSettings());
  ASSERT_EQ(led.paths.size(), 2U);
  EXPECT_EQ(led.layer, 4U);
  for (double s = 0.25; s < 80.0; s += 0.5) {
    EXPECT_NEAR(correctionAt(led.paths[1], s).amount, correctionAt(map.paths[1], s + 15.0).amount, 1e-9);
    EXPECT_NEAR(correctionAt(led.paths[1], s).dz_mm, 0.25, 1e-12) << "axes follow at once";
  }
  map.paths.push_back({9, 1.0, {{0.2, 0.0, 0.0}}});
  EXPECT_EQ(ledMap(map, layer, {1.5, 0.0}, LoopSettings()).paths.back().stations[0].amount, 0.2)
      << "of a path without cells";
  map.paths.back().spacing_mm = 1e-4;
  EXPECT_EQ(ledMap(map, layer, {1.5, 0.0}, LoopSettings()).paths[1].stations.size(),
            led.paths[1].stations.size())
      << "how short a path of one station is asks for no denser ones elsewhere";
}

TEST(FeederLead, LeadsPathsOfOneStationByTheSpacingThatTheyState) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0}, 100.0);
  const CorrectionMap stated{"part", 4, 1, {{0, 1.0, {{0.0, 0.0, 0.0}}}, {2, 1.0, {{0.1, 0.0, 0.0}}}}};
  // At 10 mm/s, a dead time of 1.5 s: the amount of the second path is due over the last 15 mm of the first.
  const CorrectionMap led = ledMap(stated, layer, {1.5, 0.0}, LoopSettings());
  ASSERT_EQ(led.paths[0].stations.size(), 100U);
  EXPECT_NEAR(correctionAt(led.paths[0], 50.0).amount, 0.0, 1e-9);
  EXPECT_NEAR(correctionAt(led.paths[0], 99.0).amount, 0.1, 1e-9);
  const CorrectionMap whole{"part", 4, 1, {{0, 100.0, {{0.0, 0.0, 0.0}}}, {2, 100.0, {{0.1, 0.0, 0.0}}}}};
  EXPECT_EQ(ledMap(whole, layer, {1.5, 0.0}, LoopSettings()).paths[0].stations.size(), 1U);
}

TEST(FeederLead, RefusesToDivideALayerIntoMoreCellsThanFit) {
  const ToolpathLayer layer = test::straightBeadLayer({0.0, 3.0}, 5000.0);
  const CorrectionMap dense{"part", 4, 1, {{0, 0.001, {{}, {0.1, 0.0, 0.0}}}}};
  try {
    ledMap(dense, layer, {1.5, 0.0}, LoopSettings());
    ADD_FAILURE() << "ten million cells";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "correction of layer 4: its 10000 mm of beads, divided by 0.001 mm between stations, are "
                 "1e+07 cells; expected at most 2e+06");
  }
}

TEST(PressedLaw, FillsWhatIsMissingWithinItsRange) {
  const LayerCells cells = test::straightBeads({0.0}, 30.0, 0.5);
  const std::vector<double> gain(cells.size(), 1.0);
  const auto amount = [&](double deficit) {
    return pressedCorrection(cells, {std::vector<double>(cells.size(), deficit), gain}, LoopSettings())
        .amount[9];
  };
  EXPECT_NEAR(amount(0.1), 0.05, kRounding);
  EXPECT_NEAR(amount(0.9), 0.15, kRounding);
  EXPECT_NEAR(amount(-0.9), -0.15, kRounding);
}

TEST(PressedLaw, CountsDrops) {
  EXPECT_EQ(dropDecision(0.24, 0.5), DropDecision::Lay);
  EXPECT_EQ(dropDecision(-0.24, 0.5), DropDecision::Lay);
  EXPECT_EQ(dropDecision(0.26, 0.5), DropDecision::LayTwo);
  EXPECT_EQ(dropDecision(-0.26, 0.5), DropDecision::Leave);
}

}  // namespace
}  // namespace lamina
