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

TEST(HeightError, LeavesOutLayersThatWereNotSeen) {
  lamina_msgs::LayerHeight unseen = layer(1, 0.0, 0.0, 0);
  unseen.coverage = 0.0;
  unseen.sight = lamina_msgs::LayerHeight::NOT_SEEN;
  const auto error = lamina::heightError({layer(0, 1e-5, 2e-5, 300), unseen});
  EXPECT_EQ(error.layers, 1U);
  EXPECT_NEAR(error.mean_mm, 0.01, 1e-12);
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

TEST(SummaryText, NamesLayersThatWereNotSeenAndProfilesThatWereNotPlaced) {
  lamina::PrintReport report;
  report.layers = {layer(0, 1e-5, -2e-5, 12), layer(77, 0.0, 0.0, 0), layer(78, 1e-5, -2e-5, 12)};
  report.layers[1].sight = lamina_msgs::LayerHeight::NOT_SEEN;
  report.layers[2].sight = lamina_msgs::LayerHeight::CUT_SHORT;
  report.counts.received = 5000;
  report.counts.lost = 12;
  report.counts.in_gap = 3;
  report.unreported = {80, 79};
  const std::string text = lamina::summaryText(report);
  for (const char* part : {"layers measured   2,", "layers not seen   3: 77, 79, 80", "layers cut short  1",
                           "profiles          5000; not placed: 12 lost on the way, 3 in gaps of poses"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(SummaryText, StatesShortTimesInMilliseconds) {
  lamina::PrintReport report;
  report.slicing.wall_time = 0.0312;
  report.slicing.estimated_time = 0.2;
  const std::string text = lamina::summaryText(report);
  for (const char* part : {"slicing time      31.2 ms", "printing time     0.2 s estimated"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(MeasurementFault, NamesLayersThatWereNotSeenOrCutShort) {
  lamina::PrintReport report;
  report.layers = {layer(0, 1e-5, -2e-5, 12), layer(1, 0.0, 0.0, 0), layer(2, 1e-5, -2e-5, 12)};
  EXPECT_EQ(lamina::measurementFault(report), "");
  report.has_everything = false;
  EXPECT_NE(lamina::measurementFault(report).find("last position and profile"), std::string::npos);
  report.layers[1].sight = lamina_msgs::LayerHeight::NOT_SEEN;
  report.layers[2].sight = lamina_msgs::LayerHeight::CUT_SHORT;
  report.unreported = {3};
  const std::string fault = lamina::measurementFault(report);
  EXPECT_EQ(fault.find("3 layers were not seen or cut short: 1, 2, 3;"), 0U) << fault;
  report.layers = {layer(0, 1e-5, -2e-5, 12)};
  const std::string fault_of_one = lamina::measurementFault(report);
  EXPECT_EQ(fault_of_one.find("1 layer was not seen or cut short: 3;"), 0U) << fault_of_one;
}

TEST(SummaryText, SaysNothingOfLayersNotSeenWhereAllWereSeen) {
  lamina::PrintReport report;
  report.layers = {layer(0, 1e-5, -2e-5, 12)};
  const std::string text = lamina::summaryText(report);
  EXPECT_EQ(text.find("not seen"), std::string::npos) << text;
  EXPECT_EQ(text.find("not placed"), std::string::npos) << text;
}

}  // namespace
