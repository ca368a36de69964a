// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/disc_coverage.hpp"

#include <gtest/gtest.h>

#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::hexLattice;
using test::rectangle;
using test::reversed;
using test::squareLattice;
using test::without;

const std::vector<Polygon> kMiddle = {rectangle(-3, -3, 3, 3)};

TEST(DiscCoverage, FindsTheLargestVoidOfAHexagonalLattice) {
  EXPECT_NEAR(discCoverage(without(hexLattice(6.0), {{0, 0}}), 1.0, kMiddle).largest_mm2, 1.0273, 0.01);
  EXPECT_NEAR(discCoverage(hexLattice(6.0), 1.0, kMiddle).largest_mm2, 0.0403, 0.004);
}

TEST(DiscCoverage, FindsTheLargestVoidOfASquareLattice) {
  EXPECT_NEAR(discCoverage(without(squareLattice(9), {{0, 0}}), 1.0, kMiddle).largest_mm2, 1.6438, 0.015);
  EXPECT_NEAR(discCoverage(squareLattice(9), 1.0, kMiddle).largest_mm2, 0.2146, 0.005);
}

TEST(DiscCoverage, HasThePorosityOfTheLattice) {
  EXPECT_NEAR(discCoverage(squareLattice(9), 1.0, kMiddle).uncovered_mm2 / 36.0, 0.2146, 0.004);
  EXPECT_EQ(discCoverage(squareLattice(9), 1.0, kMiddle).voids, 36U);
  const double row = 0.5 * std::sqrt(3.0);
  EXPECT_NEAR(
      discCoverage(hexLattice(6.0), 1.0, {rectangle(-3, -4 * row, 3, 4 * row)}).uncovered_mm2 / (6 * 8 * row),
      0.0931, 0.004);
}

TEST(DiscCoverage, LooksAtTheMaterialOnly) {
  const DiscCoverage coverage =
      discCoverage({{10, 10}}, 1.0, {rectangle(0, 0, 4, 4), reversed(rectangle(1, 1, 3, 3))});
  EXPECT_NEAR(coverage.uncovered_mm2, 12.0, 0.2);
  EXPECT_EQ(coverage.voids, 1U);
  EXPECT_EQ(discCoverage({}, 1.0, {}).voids, 0U);
}

}  // namespace
}  // namespace lamina
