// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/chain_splitting.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

using Indices = std::vector<std::size_t>;

TEST(ChainSplitting, KeepsTheEndsAndWhereItIsSplitInOrder) {
  const auto never = [](std::size_t from, std::size_t) { return from; };
  const auto halves = [](std::size_t from, std::size_t to) { return (from + to) / 2; };
  EXPECT_EQ(keptOfChain(3, 9, never), (Indices{3, 9}));
  EXPECT_EQ(keptOfChain(3, 4, halves), (Indices{3, 4}));
  EXPECT_EQ(keptOfChain(3, 9, halves), (Indices{3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(
      keptOfChain(0, 8, [](std::size_t from, std::size_t to) { return to == 8 && from < 2 ? 2 : from; }),
      (Indices{0, 2, 8}));
}

TEST(ChainSplitting, KeepsTheOnlyPointOfAChain) {
  EXPECT_EQ(keptOfChain(5, 5, [](std::size_t from, std::size_t) { return from; }), (Indices{5}));
}

TEST(ChainSplitting, ReportsThePointFarthestFromTheSegment) {
  const std::vector<Point2> points = {{0, 0}, {1, 0.3}, {-2, 0}, {5, -0.4}, {10, 0}};
  const auto at = [&](std::size_t i) { return points[i]; };
  EXPECT_EQ(farthestBetween(0, 4, 0.5, at), 2U) << "2 mm before its start";
  EXPECT_EQ(farthestBetween(2, 4, 0.1, at), 3U);
  EXPECT_EQ(farthestBetween(2, 4, 0.41, at), 2U) << "within the tolerance";
  EXPECT_EQ(farthestBetween(3, 4, 0.0, at), 3U) << "nothing in between";
}

TEST(ChainSplitting, MeasuresFromAPointIfBothEndsAreOne) {
  const std::vector<Point3> points = {{1, 1, 1}, {1, 1, 3}, {1, 4, 1}, {1, 1, 1}};
  EXPECT_EQ(farthestBetween(0, 3, 1.0, [&](std::size_t i) { return points[i]; }), 2U);
}

}  // namespace
}  // namespace lamina
