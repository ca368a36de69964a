// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_totals.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

LayerVoids voidTotalsLayerOf(double area, double uncovered, double overfill, std::size_t runs) {
  LayerVoids layer;
  layer.area_mm2 = area;
  layer.uncovered_mm2 = uncovered;
  layer.overfill_mm2 = overfill;
  layer.deposited_mm2 = area - uncovered + overfill;
  layer.runs = runs;
  return layer;
}

TEST(VoidTotals, ReportTheMeanOfTheLayersTheWholeAndTheWorst) {
  const VoidTotals sums = totals(
      {voidTotalsLayerOf(100, 1, 4, 2), voidTotalsLayerOf(10, 1, 0, 3), voidTotalsLayerOf(0, 0, 0, 0)});
  EXPECT_EQ(sums.layers, 3U);
  EXPECT_DOUBLE_EQ(sums.uncovered.mean_percent, (1.0 + 10.0) / 2) << "a layer without area has no percentage";
  EXPECT_DOUBLE_EQ(sums.uncovered.total_percent, 100.0 * 2 / 110);
  EXPECT_DOUBLE_EQ(sums.uncovered.worst_percent, 10.0);
  EXPECT_EQ(sums.uncovered.worst_layer, 1U);
  EXPECT_DOUBLE_EQ(sums.overfill.mean_percent, 2.0);
  EXPECT_EQ(sums.overfill.worst_layer, 0U);
  EXPECT_DOUBLE_EQ(sums.material_percent, 100.0 * (103 + 9) / 110);
  EXPECT_DOUBLE_EQ(sums.runs_per_layer_mean, 5.0 / 3);
}

TEST(VoidTotals, OfNoLayersAreNone) {
  const VoidTotals sums = totals(std::vector<LayerVoids>{});
  EXPECT_EQ(sums.layers, 0U);
  EXPECT_EQ(sums.uncovered.mean_percent, 0.0);
  EXPECT_EQ(sums.runs_per_layer_mean, 0.0);
}

}  // namespace
}  // namespace lamina
