// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/replanning.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "support/control_layers.hpp"

namespace lamina {
namespace {

double sum(const std::vector<double>& heights) {
  return std::accumulate(heights.begin(), heights.end(), 0.0);
}

TEST(Replanning, ScalesTheHeightsLeftToTheSameTop) {
  const PartUnderWay part{std::vector<double>(20, 1.5), 2.4, 0.63};
  const auto heights = scaledHeights(part, {});
  ASSERT_TRUE(heights);
  EXPECT_EQ(heights->heights_mm.size(), 20U);
  EXPECT_NEAR(sum(heights->heights_mm), 32.4, 1e-9);
  EXPECT_NEAR(heights->flow, 1.0 / 0.63, 1e-12);
}

TEST(Replanning, ChangesTheNumberOfLayersWhereScalingWouldBeTooMuch) {
  const auto more = scaledHeights({std::vector<double>(2, 1.5), 3.0, 1.0}, {});
  ASSERT_TRUE(more);
  EXPECT_EQ(more->heights_mm.size(), 4U);
  EXPECT_NEAR(sum(more->heights_mm), 6.0, 1e-12);
  const auto fewer = scaledHeights({std::vector<double>(4, 1.5), -3.0, 1.0}, {});
  ASSERT_TRUE(fewer);
  EXPECT_EQ(fewer->heights_mm.size(), 2U);
}

TEST(Replanning, KeepsTheWindowOfTheProcess) {
  LayerWindow window;
  window.greatest_mm = 1.55;
  const auto heights = scaledHeights({std::vector<double>(20, 1.5), 2.4, 1.0}, window);
  ASSERT_TRUE(heights);
  EXPECT_EQ(heights->heights_mm.size(), 22U);  // 32.4 / 1.5 = 21.6
  EXPECT_NEAR(sum(heights->heights_mm), 32.4, 1e-9);
  window.least_mm = 1.54;
  EXPECT_FALSE(scaledHeights({{1.5}, 0.3, 1.0}, window))
      << "1.8 mm are no number of layers of 1.54 to 1.55 mm";
  EXPECT_FALSE(scaledHeights({{}, 0.3, 1.0}, {}));
  EXPECT_FALSE(scaledHeights({{1.5}, -1.6, 1.0}, {})) << "the part is there already";
}

TEST(Replanning, IsNeededWhereAmountsWillNotDo) {
  const LayerAuthority authority{-0.2, 0.5};
  // 0.7 of the growth, and half as much again: 5 % are lost of every layer left.
  const PartUnderWay clogged{std::vector<double>(20, 1.5), 0.5, 0.63};
  EXPECT_NEAR(expectedTopError(clogged, authority), 0.5 + 0.055 * 30.0, 1e-9);
  EXPECT_TRUE(needsReplanning(clogged, 1.5, authority));
  const PartUnderWay sound{std::vector<double>(20, 1.5), 0.5, 0.9};
  EXPECT_EQ(expectedTopError(sound, authority), 0.0) << "it will be caught up";
  EXPECT_FALSE(needsReplanning(sound, 1.5, authority));
  EXPECT_TRUE(needsReplanning({std::vector<double>(20, 1.5), 1.6, 1.0}, 1.5, authority))
      << "more than a layer";
}

TEST(Replanning, IsNotNeededWhereSmallerAmountsTakeOffWhatIsTooHigh) {
  const LayerAuthority authority{-0.2, 0.5};
  // 30 mm are left and 29.1 mm wanted: 3 % less of each layer.
  const PartUnderWay high{std::vector<double>(20, 1.5), -0.9, 1.0};
  EXPECT_EQ(expectedTopError(high, authority), 0.0);
  EXPECT_FALSE(needsReplanning(high, 1.5, authority));
  // With two layers left, 2.4 mm is the least that they grow, and 2.1 mm are wanted.
  EXPECT_NEAR(expectedTopError({{1.5, 1.5}, -0.9, 1.0}, authority), -0.3, 1e-12);
  // A feeder that gives twice as much grows 48 mm at least.
  const PartUnderWay fed{std::vector<double>(20, 1.5), -0.9, 2.0};
  EXPECT_NEAR(expectedTopError(fed, authority), 29.1 - 48.0, 1e-9);
  EXPECT_TRUE(needsReplanning(fed, 1.5, authority));
}

TEST(Replanning, AddsLayersToWideDipsAndBeadsToSmallOnes) {
  const LayerCells cells = test::straightBeads({0.0}, 60.0, 1.0);
  std::vector<double> error(cells.size(), 0.0);
  for (std::size_t i = 5; i < 14; ++i) error[i] = 1.2;    // 9 mm: three beads
  for (std::size_t i = 20; i < 28; ++i) error[i] = 1.2;   // 8 mm
  for (std::size_t i = 35; i < 50; ++i) error[i] = -1.2;  // 15 mm
  for (std::size_t i = 54; i < 56; ++i) error[i] = -1.2;
  const auto decisions = regionDecisions(cells, error);
  ASSERT_EQ(decisions.size(), 3U);
  EXPECT_EQ(decisions[0].step, RegionStep::AddLayer);
  EXPECT_EQ(decisions[0].first, 5U);
  EXPECT_EQ(decisions[0].count, 9U);
  EXPECT_EQ(decisions[1].step, RegionStep::FillBeads);
  EXPECT_EQ(decisions[2].step, RegionStep::SkipLayer);
  EXPECT_EQ(decisions[2].first, 35U);
}

TEST(Replanning, CutsNoDipAtTheSeamOfAClosedPath) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, 40.0);
  layer.paths[0].points = {{0, 0, 1.5}, {40, 0, 1.5}, {40, 40, 1.5}, {0, 40, 1.5}};
  layer.paths[0].is_closed = true;
  const LayerCells cells = layerCells(layer, 0, 1.0);
  std::vector<double> error(cells.size(), 0.0);
  for (std::size_t i = 0; i < 6; ++i) error[i] = error[cells.size() - 1 - i] = 1.2;  // 12 mm: four beads
  const auto decisions = regionDecisions(cells, error);
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions[0].step, RegionStep::AddLayer);
  EXPECT_EQ(decisions[0].first, cells.size() - 6);
  EXPECT_EQ(decisions[0].count, 12U);
  const auto everywhere = regionDecisions(cells, std::vector<double>(cells.size(), 1.2));
  ASSERT_EQ(everywhere.size(), 1U);
  EXPECT_EQ(everywhere[0].count, cells.size());
}

}  // namespace
}  // namespace lamina
