// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/layer_trim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// Whether a layer is trimmed whose beads are all seen 0.15 mm lower than they were expected.
bool isTrimmedOver(const CellEstimate& ground) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 1.5);
  LoopSettings settings;
  settings.trim = 0.5;
  settings.sensor_behind_mm = 6.0;
  std::vector<CellEstimate> estimates(cells.size(), ground);
  for (CellEstimate& cell : estimates) cell.lay({1.5, 0.0, 0.0}, 0.1);
  auto trim = layerTrim(cells, estimates, std::vector<double>(cells.size(), 0.0), settings);
  if (!trim) return false;
  for (CellEstimate& cell : estimates) cell.see({cell.error() + 0.15, 6, 0.02}, 0.0);
  return trim->advance(20, estimates);
}

TEST(LayerTrim, FeedsMoreWhereLessGrows) { EXPECT_TRUE(isTrimmedOver(CellEstimate(0.0, 0.05, 1.0))); }

/// Amounts of a layer of 40 cells, all of `planned`, of which every one is seen 0.3 mm too low or too high.
std::vector<double> trimmedTo(double planned, double error_mm) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 1.5);
  LoopSettings settings;
  settings.trim = 0.5;
  settings.sensor_behind_mm = 6.0;
  std::vector<CellEstimate> estimates(cells.size(), CellEstimate(0.0, 0.05, 1.0));
  for (CellEstimate& cell : estimates) cell.lay({1.5, planned, 0.0}, 0.1);
  auto trim = layerTrim(cells, estimates, std::vector<double>(cells.size(), planned), settings);
  for (CellEstimate& cell : estimates) cell.see({cell.error() + error_mm, 6, 0.02}, 0.0);
  for (std::size_t laid = 1; laid <= cells.size(); ++laid) trim->advance(laid, estimates);
  return trim->amount();
}

TEST(LayerTrim, KeepsTheVolumeThatTheLayersMapHasLeft) {
  for (const double side : {1.0, -1.0}) {
    const std::vector<double> amount = trimmedTo(0.19 * side, 0.3 * side);
    const double mean = std::accumulate(amount.begin(), amount.end(), 0.0) / 40.0;
    EXPECT_NEAR(mean, 0.2 * side, 0.003) << "what is left is used but for changes too small to be reported";
    EXPECT_LE(std::abs(mean), 0.2 + 1e-12);
    EXPECT_GT(std::abs(amount.back()), 0.19 + 1e-3);
  }
  const std::vector<double> back = trimmedTo(0.19, -0.3);
  EXPECT_LT(back.back(), 0.1) << "less is not bounded by it";
}

/// A bead over air is as low as what it lies on.
TEST(LayerTrim, TakesASagOverNothingForNoLackOfFeed) { EXPECT_FALSE(isTrimmedOver(CellEstimate())); }

}  // namespace
}  // namespace lamina
