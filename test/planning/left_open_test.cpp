// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/left_open.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lamina/planning/planner.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kSquareArea = 100.0;
/// A square of 10 mm with a fin of 10 x 0.3 mm at its side, narrower than a cell of 0.357 mm.
const Polygon kFinned = {{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 4.3}, {10, 4.3}, {10, 10}, {0, 10}};
constexpr double kFinArea = 3.0;

LeftOpen leftOpenBy(const std::string& strategy, double density) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.walls.count = 0;
  settings.infill.strategy = strategy;
  settings.infill.density = density;
  const std::vector<Layer> layers = {{{0.0, 0.2}, {{test::rectangle(0, 0, 10, 10)}, {}}},
                                     {{0.2, 0.4}, {{kFinned}, {}}}};
  NoProgress progress;
  return planPart("fin", layers, settings, progress).left_open;
}

TEST(LeftOpen, CountsAFinThatNoCellFitsInto) {
  for (const char* strategy : {"hilbert", "hilbert_quadtree"}) {
    const LeftOpen open = leftOpenBy(strategy, 1.0);
    EXPECT_NEAR(open.area_mm2, 2.0 * kSquareArea + kFinArea, 0.05) << strategy;
    EXPECT_GT(open.open_mm2, 0.95 * kFinArea) << strategy;
    EXPECT_GT(open.worst_percent, 100.0 * 0.95 * kFinArea / (kSquareArea + kFinArea)) << strategy;
    EXPECT_EQ(open.worst_layer, 1U) << strategy;
    EXPECT_GE(open.open_layers, 1U) << strategy;
  }
}

LeftOpen leftOpenInRegion(const std::string& strategy, const std::string& strategy_of_region,
                          const Regions& region) {
  const auto settingsOf = [](const std::string& name) {
    PlanSettings settings;
    settings.skirt.count = 0;
    settings.walls.count = 0;
    settings.infill.strategy = name;
    settings.infill.density = 1.0;
    return settings;
  };
  const std::vector<Layer> layers = {{{0.0, 0.2}, {{kFinned}, {}}}};
  const std::vector<PlanVariant> variants = {{settingsOf(strategy_of_region), {region}}};
  NoProgress progress;
  const VariedBed bed{Box2{{-100.0, -100.0}, {100.0, 100.0}}, variants};
  return planPart("fin", layers, settingsOf(strategy), bed, progress).left_open;
}

// The region is the fin alone, with the 0.5 mm beside it.
TEST(LeftOpen, CountsOfALayerWithRegionsThoseInCells) {
  const Regions fin = {Region{test::rectangle(9.5, 3.5, 21, 4.8), {}}};
  constexpr double kRegionArea = kFinArea + 0.5 * 1.3;
  const LeftOpen of_region = leftOpenInRegion("zigzag", "hilbert", fin);
  EXPECT_NEAR(of_region.area_mm2, kRegionArea, 0.05);
  EXPECT_GT(of_region.open_mm2, 0.95 * kFinArea);
  EXPECT_EQ(of_region.open_layers, 1U);
  const LeftOpen of_rest = leftOpenInRegion("hilbert", "zigzag", fin);
  EXPECT_NEAR(of_rest.area_mm2, kSquareArea + kFinArea - kRegionArea, 0.05);
  const LeftOpen of_both = leftOpenInRegion("hilbert", "hilbert", fin);
  EXPECT_NEAR(of_both.area_mm2, kSquareArea + kFinArea, 0.05);
  EXPECT_GT(of_both.open_mm2, 0.95 * kFinArea);
  EXPECT_EQ(leftOpenInRegion("zigzag", "zigzag", fin).area_mm2, 0.0);
}

TEST(LeftOpen, IsNotMeasuredWhereAFillIsSparseOrFitted) {
  EXPECT_EQ(leftOpenBy("hilbert_quadtree", 0.5).area_mm2, 0.0);
  EXPECT_EQ(leftOpenBy("zigzag", 1.0).area_mm2, 0.0);
}

}  // namespace
}  // namespace lamina
