// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/path_cuts.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace lamina {
namespace {

using Cuts = std::vector<std::size_t>;

TEST(PathCuts, ClosedLoopIsCutBeforeItsLastLine) {
  // [Vega2023, figure 22]: the fourth of five rows.
  EXPECT_EQ(pathCuts({{2, 2}, {41.5, 2}, {41.5, 6.5}, {2, 6.5}, {2, 2}}, 0.4968), Cuts{3});
}

TEST(PathCuts, EndsHalfAWidthApartAreNotClosed) {
  EXPECT_EQ(pathCuts({{0, 0}, {10, 0}, {10, 10}, {0, 0.24}}, 0.48), (Cuts{}));
  EXPECT_EQ(pathCuts({{0, 0}, {10, 0}, {10, 10}, {0, 0.23}}, 0.48), Cuts{2});
}

/// Turns right at a maximum of x and, `between` points later, left at a minimum of x that lies `apart` of it.
std::vector<Point2> turn(int between, double apart) {
  std::vector<Point2> points = {{0, 0}, {2, 1}, {4, 0}};
  // Out and back below, without another peak of x.
  for (int i = 1; i <= between; ++i) {
    const double part = double(i) / (between + 1);
    points.emplace_back(4 - part * apart, -4 * part * (1 - part));
  }
  points.emplace_back(4 - apart, 0);
  points.emplace_back(6, 2);
  points.emplace_back(8, 0.5);
  return points;
}

TEST(PathCuts, IsCutAtPeaksOfTheOtherAxisWhereItMeetsItself) {
  // x: maximum at 2, minimum at 2 + between + 1. y: maxima at 1 and the last but one, minimum between.
  EXPECT_EQ(pathCuts(turn(3, 0.4), 0.48), (Cuts{1, 4, 7}));
}

TEST(PathCuts, PeaksThreePointsApartAreNotCompared) { EXPECT_EQ(pathCuts(turn(2, 0.4), 0.48), (Cuts{})); }

TEST(PathCuts, NeighboursOfPeaksCountUpToHalfAWidthMore) {
  // The peaks, 2 and 9, are 0.6 apart; the points two beyond them, 4 and 7, 0.49 and then 0.45.
  std::vector<Point2> points = {{0, 0},    {2, 1},     {4, 0},     {3.99, -3}, {3.98, -6}, {3.7, -8},
                                {3.6, -8}, {3.49, -6}, {3.45, -3}, {3.4, 0},   {6, 2},     {8, 0.5}};
  EXPECT_EQ(pathCuts(points, 0.48), (Cuts{}));
  points[7].x() = 3.53;
  EXPECT_EQ(pathCuts(points, 0.48), (Cuts{1, 5, 10}));
  EXPECT_EQ(pathCuts(points, 0.39), (Cuts{}));  // 0.6 is more than 1.5 widths
}

TEST(PathCuts, NeighboursStayWithinThePath) {
  // Peaks next to both ends.
  const std::vector<Point2> points = {{0, 0}, {1, 0.1}, {0.8, -3}, {0.6, -4}, {0.5, -3}, {0.4, 0}, {1, 3}};
  EXPECT_EQ(pathCuts(points, 0.48), (Cuts{1, 3}));
}

TEST(PathCuts, AreRisingInnerPoints) {
  EXPECT_TRUE(rc::check("cuts rise and are neither end", [] {
    const auto count = *rc::gen::inRange(2, 40);
    std::vector<Point2> points;
    for (int i = 0; i < count; ++i)
      points.emplace_back(*rc::gen::inRange(-20, 20) * 0.1, *rc::gen::inRange(-20, 20) * 0.1);
    std::size_t before = 0;
    for (const std::size_t cut : pathCuts(points, 0.48)) {
      RC_ASSERT(cut > before);
      RC_ASSERT(cut + 1 < points.size());
      before = cut;
    }
  }));
}

}  // namespace
}  // namespace lamina
