// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert_order.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

namespace lamina {
namespace {

bool areNeighbours(const Cell& a, const Cell& b) {
  return std::abs(a.column - b.column) + std::abs(a.row - b.row) == 1;
}

TEST(HilbertOrder, OfFourCellsIsAnArch) {
  EXPECT_EQ(hilbertOrder(2, 2), (std::vector<Cell>{{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
}

TEST(HilbertOrder, GoesFromNeighbourToNeighbourOverASquareOfAPowerOfTwo) {
  for (const int side : {1, 2, 4, 8, 32}) {
    const std::vector<Cell> order = hilbertOrder(side, side);
    ASSERT_EQ(order.size(), static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (std::size_t i = 1; i < order.size(); ++i) EXPECT_TRUE(areNeighbours(order[i - 1], order[i])) << i;
    EXPECT_EQ(order.back(), (Cell{side - 1, 0}));
  }
}

TEST(HilbertOrder, VisitsEachCellOfAnyLatticeOnce) {
  for (const auto& [columns, rows] : {std::pair(5, 3), std::pair(1, 17), std::pair(100, 2)}) {
    std::set<std::pair<int, int>> seen;
    for (const Cell& cell : hilbertOrder(columns, rows)) {
      EXPECT_TRUE(cell.column >= 0 && cell.column < columns && cell.row >= 0 && cell.row < rows);
      EXPECT_TRUE(seen.insert({cell.column, cell.row}).second);
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  }
  EXPECT_TRUE(hilbertOrder(0, 3).empty());
}

TEST(HilbertOrder, IsTheOrderOfThePlaces) {
  for (const int level : {1, 2, 3, 5}) {
    const std::vector<Cell> order = hilbertOrder(1 << level, 1 << level);
    for (std::size_t i = 0; i < order.size(); ++i) {
      EXPECT_EQ(hilbertPlace(order[i], level), i) << "level " << level;
    }
  }
}

}  // namespace
}  // namespace lamina
