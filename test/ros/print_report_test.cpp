// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/print_part/print_report.hpp"

#include <gtest/gtest.h>

namespace {

lamina_msgs::LayerHeight layer(std::uint32_t number, double mean_m, double worst_m, std::uint32_t cells) {
  lamina_msgs::LayerHeight height;
  height.layer = number;
  height.expected_height = 0.0003 * (number + 1);
  height.mean_error = mean_m;
  height.worst_error = worst_m;
  height.coverage = 0.5;
  height.cells = cells;
  return height;
}

TEST(HeightError, WeighsEachLayerByTheCellsSeen) {
  const auto error = lamina::heightError({layer(0, 1e-5, 2e-5, 300), layer(1, -3e-5, -9e-5, 100)});
  EXPECT_NEAR(error.mean_mm, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(error.worst_mm, -0.09);
  EXPECT_DOUBLE_EQ(error.coverage, 0.5);
}

TEST(HeightError, OfNoLayerIsZero) { EXPECT_EQ(lamina::heightError({}).mean_mm, 0.0); }

TEST(SummaryText, ReportsLayersLinesResendsAndHeightError) {
  lamina::PrintReport report;
  report.part = "blade";
  report.slicing.layers = 117;
  report.streaming.lines_acknowledged = 4321;
  report.streaming.resends = 3;
  report.layers = {layer(0, 1e-5, -2e-5, 12)};
  const std::string text = lamina::summaryText(report);
  for (const char* part : {"blade", "117", "4321", "resends           3", "mean 0.0100 mm, worst -0.0200 mm"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
