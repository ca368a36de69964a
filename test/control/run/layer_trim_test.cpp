// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/layer_trim.hpp"

#include <gtest/gtest.h>

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

/// A bead over air is as low as what it lies on.
TEST(LayerTrim, TakesASagOverNothingForNoLackOfFeed) { EXPECT_FALSE(isTrimmedOver(CellEstimate())); }

}  // namespace
}  // namespace lamina
