// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/collapsing_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

/// From a point on, each edge turned by so many degrees against the one before, and so long [mm].
CollapsingChain chainOf(const std::vector<std::pair<double, double>>& turns_and_lengths) {
  double heading = 0.0;
  Point2 at(3.0, -2.0);
  CollapsingChain chain({1.0, 0.0});
  for (const auto& [turn, length] : turns_and_lengths) {
    heading += turn * M_PI / 180.0;
    const Point2 direction(std::cos(heading), std::sin(heading));
    chain.add(at, direction);
    at += length * direction;
  }
  return chain;
}

/// Tangent of half an angle in degrees: by so much an edge becomes shorter at a corner, per distance.
double half(double degrees) { return std::tan(0.5 * degrees * M_PI / 180.0); }

TEST(CollapsingChain, OfAChamferVanishesWhenItsLengthIsUsedUp) {
  const double distance = 0.1 / (2.0 * half(45));
  EXPECT_TRUE(chainOf({{45, 0.1}, {45, 9}}).collapsesWithin(distance + 1e-3));
  EXPECT_FALSE(chainOf({{45, 0.1}, {45, 9}}).collapsesWithin(distance - 1e-3));
}

TEST(CollapsingChain, BesideAnOpeningCornerLosesTheDifference) {
  const double distance = 0.1 / (half(45) - half(20));
  EXPECT_TRUE(chainOf({{45, 0.1}, {-20, 9}}).collapsesWithin(distance + 1e-3));
  EXPECT_FALSE(chainOf({{45, 0.1}, {-20, 9}}).collapsesWithin(distance - 1e-3));
  EXPECT_TRUE(chainOf({{-20, 0.1}, {45, 9}}).collapsesWithin(distance + 1e-3)) << "the other way round";
}

TEST(CollapsingChain, LosesOneEdgeAfterTheOther) {
  // The second edge vanishes first; from then on the third stands between the first and the last.
  const double first = 0.05 / (half(30) - half(10));
  const double left = 0.1 + first * (half(10) - half(25));
  const double second = first + left / (half(20) + half(25));
  EXPECT_TRUE(chainOf({{30, 0.05}, {-10, 0.1}, {25, 9}}).collapsesWithin(second + 1e-3));
  EXPECT_FALSE(chainOf({{30, 0.05}, {-10, 0.1}, {25, 9}}).collapsesWithin(second - 1e-3));
}

TEST(CollapsingChain, KeepsWhatGrows) {
  EXPECT_FALSE(chainOf({{-20, 0.1}, {-20, 9}}).collapsesWithin(100.0));
  EXPECT_FALSE(chainOf({{20, 0.1}, {-45, 9}}).collapsesWithin(100.0));
  EXPECT_FALSE(chainOf({{0, 0.1}, {0, 9}}).collapsesWithin(100.0));
}

TEST(CollapsingChain, OfTwoEdgesHasNothingToLose) { EXPECT_TRUE(chainOf({{90, 9}}).collapsesWithin(0.1)); }

}  // namespace
}  // namespace lamina
