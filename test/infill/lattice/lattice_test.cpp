// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lattice/lattice.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

std::size_t cellsInside(const Lattice& lattice) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < lattice.size(); ++cell) count += lattice.isInside(cell) ? 1 : 0;
  return count;
}

TEST(Lattice, FitsTheBoxOfTheRegion) {
  // 10.3 / 1 and 5.2 / 1 round to 10 and 5 steps.
  const Lattice lattice({rectangle(2, 3, 12.3, 8.2), {}}, 1.0, 0.0);
  EXPECT_EQ(lattice.frame.columns(), 11);
  EXPECT_EQ(lattice.frame.rows(), 6);
  EXPECT_EQ(cellsInside(lattice), 66U);
  EXPECT_NEAR((lattice.frame.centre({0, 0}) - Point2(2.05, 3.05)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((lattice.frame.centre({10, 5}) - Point2(12.25, 8.15)).norm(), 0.0, 1e-12);
  for (std::size_t cell = 0; cell < 66; ++cell) {
    EXPECT_EQ(lattice.leadsRight(cell), cell % 11 < 10);
    EXPECT_EQ(lattice.leadsUp(cell), cell / 11 < 5);
  }
}

TEST(Lattice, HasOneRowInTheMiddleOfANarrowRegion) {
  const Lattice lattice({rectangle(0, 0, 10, 0.3), {}}, 1.0, 0.0);
  EXPECT_EQ(lattice.frame.rows(), 1);
  EXPECT_NEAR(lattice.frame.centre({0, 0}).y(), 0.15, 1e-12);
}

TEST(Lattice, LeadsNowhereAcrossASlitBetweenItsCells) {
  const Regions slit = difference({{rectangle(0, 0, 4.2, 4.2), {}}}, {{rectangle(2.5, -1, 2.6, 9), {}}});
  ASSERT_EQ(slit.size(), 2U);
  const Lattice lattice({rectangle(0, 0, 4.2, 4.2), {reversed(rectangle(2.5, 0.5, 2.6, 3.5))}}, 1.0, 0.0);
  ASSERT_EQ(lattice.frame.columns(), 5);
  for (const int row : {1, 2, 3}) EXPECT_FALSE(lattice.leadsRight(lattice.indexOf({2, row}))) << row;
  for (const int row : {0, 4}) EXPECT_TRUE(lattice.leadsRight(lattice.indexOf({2, row}))) << row;
}

TEST(Lattice, HoldsThePointsThatTheRegionContains) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Region region{test::star(random, {1, 2}, 5.0, 12.0, 24),
                        {reversed(test::star(random, {1, 2}, 1.0, 4.0, 12))}};
    const std::vector<Polygon> borders = outlines({region});
    const Lattice lattice(region, random.uniform(0.3, 3.0), random.uniform(-4, 4));
    for (int row = 0; row < lattice.frame.rows(); ++row)
      for (int column = 0; column < lattice.frame.columns(); ++column) {
        const Point2 centre = lattice.frame.centre({column, row});
        if (test::distanceToOutline(borders, centre) > 1e-9) {
          RC_ASSERT(lattice.isInside(lattice.indexOf({column, row})) == contains(borders, centre));
        }
      }
  }));
}

TEST(Lattice, LeadsAlongTheDiagonalsOfAStrip) {
  // The cells lie at 0.05 + k: their diagonal runs inside a strip along y = x, the other one leaves it.
  Lattice lattice({{{0, 0}, {0.3, 0}, {5.1, 4.8}, {5.1, 5.1}, {4.8, 5.1}, {0, 0.3}}, {}}, 1.0, 0.0);
  ASSERT_EQ(lattice.frame.columns(), 6);
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(lattice.leadsUpRight(lattice.indexOf({i, i}))) << "not found yet";
  lattice.findDiagonals();
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(lattice.leadsUpRight(lattice.indexOf({i, i}))) << i;
  for (std::size_t cell = 0; cell < lattice.size(); ++cell) EXPECT_FALSE(lattice.leadsUpLeft(cell));
}

TEST(Lattice, LeadsAlongBothDiagonalsInTheOpen) {
  Lattice lattice({rectangle(0, 0, 3.1, 2.1), {}}, 1.0, 0.0);
  lattice.findDiagonals();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column) {
      EXPECT_EQ(lattice.leadsUpRight(lattice.indexOf({column, row})), column < 3);
      EXPECT_EQ(lattice.leadsUpLeft(lattice.indexOf({column, row})), column > 0);
    }
}

TEST(Lattice, RefusesASpacingThatGivesTooManyCells) {
  EXPECT_THROW(Lattice({rectangle(0, 0, 1000, 1000), {}}, 1e-3, 0.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
