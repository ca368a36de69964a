// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/flow_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// 0.45 x 0.2 mm with round sides.
constexpr double kNominal = 0.25 * 0.2 + M_PI * 0.01;

TEST(FlowTrial, HasSquaresOfStatedMultipliers) {
  const FlowTrialSettings settings;
  const std::vector<double> multipliers = flowMultipliers(settings);
  ASSERT_EQ(multipliers.size(), 7U);
  EXPECT_NEAR(multipliers.front(), 0.85, 1e-12);
  EXPECT_NEAR(multipliers[3], 1.0, 1e-12);
  EXPECT_NEAR(multipliers.back(), 1.15, 1e-12);
  const Toolpath toolpath = flowTrialToolpath(settings);
  validate(toolpath);
  ASSERT_EQ(toolpath.layers.size(), 30U);
  std::size_t square = 0;
  for (const Path& path : toolpath.layers[12].paths) {
    if (path.role == PathRole::Travel) continue;
    EXPECT_NEAR(crossSection(path.bead.at(0)), multipliers[square] * kNominal, 1e-9);
    EXPECT_NEAR(length(path), 60.0, 1e-9);
    EXPECT_NEAR(path.points[0].x(), 100.0 + 25.0 * (static_cast<double>(square) - 3.0) + 7.5, 1e-9);
    EXPECT_NEAR(path.points[0].z(), 13 * 0.2, 1e-9);
    ++square;
  }
  EXPECT_EQ(square, 7U);
}

/// A wall of t mm is t - (1 - pi/4) 0.2 mm wide on the mean.
TEST(FlowTrial, FindsWhatWasExtrudedByThicknesses) {
  const FlowTrialSettings settings;
  std::string table = "multiplier,thickness_mm\n";
  for (const double multiplier : flowMultipliers(settings)) {
    const double thickness = 0.94 * multiplier * kNominal / 0.2 + (1.0 - M_PI / 4.0) * 0.2;
    table += std::to_string(multiplier) + "," + std::to_string(thickness) + "\n";
  }
  const FlowFit fit = fitFlow(flowReadings(table, "walls.csv", settings), settings);
  EXPECT_NEAR(fit.share, 0.94, 1e-5);
  EXPECT_NEAR(fit.factor, 1.0 / 0.94, 1e-5);
  EXPECT_NEAR(fit.follows, 1.0, 1e-4);
  EXPECT_EQ(fit.readings, 7U);
  // 0.02 mm of 0.2 mm high layers, over the root of the sum of squares of seven sections.
  EXPECT_NEAR(fit.share_spread, 0.004 / (kNominal * std::sqrt(7.0 + 2.0 * (0.0025 + 0.01 + 0.0225))), 1e-5);
}

/// Of 400 trials with readings that scatter by 0.03 mm, 68 % find the share within the spread that they
/// state.
TEST(FlowTrial, StatesItsSpread) {
  const FlowTrialSettings settings;
  Random random(5);
  int within = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<FlowReading> readings;
    for (const double multiplier : flowMultipliers(settings))
      readings.push_back({multiplier, 1.05 * multiplier * kNominal + random.normal(0.0, 0.2 * 0.03)});
    const FlowFit fit = fitFlow(readings, settings);
    if (std::abs(fit.share - 1.05) <= fit.share_spread) ++within;
  }
  EXPECT_NEAR(within / 400.0, 0.68, 0.07);
}

TEST(FlowTrial, TellsAReadingThatIsAlwaysTooThick) {
  FlowTrialSettings settings;
  settings.reading_mm = 1e-4;
  std::vector<FlowReading> readings;
  for (const double multiplier : flowMultipliers(settings))
    readings.push_back({multiplier, 0.8 * multiplier * kNominal + 0.2 * kNominal});
  const FlowFit fit = fitFlow(readings, settings);
  EXPECT_NEAR(fit.follows, 0.8, 0.01);
  EXPECT_GT((1.0 - fit.follows) / fit.follows_spread, 3.0);
}

std::string refusalOfReadings(const std::string& table) {
  try {
    fitFlow(flowReadings(table, "walls.csv", {}), {});
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(FlowTrial, RefusesReadingsThatSayNothing) {
  EXPECT_EQ(refusalOfReadings("multiplier,thickness_mm\n1,0.45\n0.9,0.41\n"),
            "there are 2 readings of walls; expected at least 3");
  EXPECT_EQ(refusalOfReadings("multiplier,thickness_mm\n1,0.45\n1,0.45\n1,0.46\n"),
            "all readings are of the multiplier 1; expected walls of two multipliers at least");
  EXPECT_EQ(refusalOfReadings("multiplier,thickness_mm\n1,0.45\n0,0.45\n"),
            "'walls.csv' line 3: multiplier is 0; expected above 0");
  EXPECT_NE(
      refusalOfReadings("multiplier,thickness_mm\n1,0.01\n").find("thickness_mm is 0.01; expected above"),
      std::string::npos);
  EXPECT_NE(refusalOfReadings("multiplier,width_mm\n1,0.45\n").find("no column 'thickness_mm'"),
            std::string::npos);
}

TEST(FlowTrial, RefusesSettingsThatContradictEachOther) {
  FlowTrialSettings settings;
  settings.layer_mm = 0.4;
  EXPECT_THROW(flowTrialToolpath(settings), InvalidConfig) << "0.85 of 0.45 mm is less";
  settings = {};
  settings.side_mm = 1.8;
  EXPECT_THROW(flowTrialToolpath(settings), InvalidConfig);
  settings = {};
  settings.gap_mm = 0.9;
  EXPECT_THROW(flowTrialToolpath(settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
