// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/overlap_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/drop_lattices.hpp"

namespace lamina {
namespace {

TEST(OverlapMeter, OfDropsInAllPoresOfASquareLatticeIsThatOfTheirDiscs) {
  std::vector<Point2> pores;
  for (int y = -4; y < 4; ++y)
    for (int x = -4; x < 4; ++x) pores.emplace_back(x + 0.5, y + 0.5);
  const OverlapReading reading = measureOverlap(test::squareLattice(9), pores, 1.0);
  EXPECT_NEAR(reading.perNewDrop(), 0.727, 5e-4);
  EXPECT_NEAR(reading.perDrop(), 0.321, 5e-4);
  EXPECT_NEAR(reading.greatest_linear, 0.2929, 5e-5);
  EXPECT_NEAR(reading.greatest_area, 0.1817, 5e-5);
}

TEST(OverlapMeter, CountsPairsOfNewDropsAmongTheGreatestOnly) {
  const OverlapReading reading = measureOverlap({{0, 0}}, {{5, 0}, {5.5, 0}}, 1.0);
  EXPECT_NEAR(reading.greatest_linear, 0.5, 1e-12);
  EXPECT_EQ(reading.sum_area, 0.0);
}

TEST(OverlapMeter, AddsLayersUp) {
  const OverlapReading sum =
      measureOverlap({{0, 0}}, {{0.5, 0}}, 1.0) + measureOverlap({{0, 0}, {3, 0}}, {{0.8, 0}}, 1.0);
  EXPECT_EQ(sum.prior, 3U);
  EXPECT_EQ(sum.added, 2U);
  // Of two discs whose middles are s diameters apart, each lies in the other by that part.
  const auto shared = [](double s) { return 2.0 / M_PI * (std::acos(s) - s * std::sqrt(1.0 - s * s)); };
  EXPECT_NEAR(sum.perNewDrop(), 0.5 * (shared(0.5) + shared(0.8)), 1e-9);
  EXPECT_NEAR(sum.greatest_linear, 0.5, 1e-12);
}

TEST(OverlapMeter, ReadsNothingWithoutDrops) {
  EXPECT_EQ(measureOverlap({}, {}, 1.0).perDrop(), 0.0);
  EXPECT_EQ(measureOverlap({{0, 0}}, {}, 1.0).perNewDrop(), 0.0);
}

}  // namespace
}  // namespace lamina
