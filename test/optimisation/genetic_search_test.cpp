// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/genetic_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "optimisation/test_problems.hpp"

namespace lamina {
namespace {

class CancelledProgress final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return true; }
};

/// Least at pitch 1.7, 3 walls, layers of 0.2 and the choice "average".
Merit meritOfMixed(const DesignPoint& point) {
  return {0.0, std::pow(point[0] - 1.7, 2.0) + std::abs(point[1] - 3.0) + 50.0 * std::abs(point[2] - 0.2) +
                   (point[3] == 1.0 ? 0.0 : 1.0)};
}

TEST(GeneticSearchTest, FindsTheBestOfVariablesOfEveryKind) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    NoProgress progress;
    const Fittest found = searchGenetically(mixedSpace(), meritOfMixed, {}, seed, progress);
    EXPECT_NO_THROW(requireWithin(mixedSpace(), found.point));
    EXPECT_NEAR(found.point[0], 1.7, 0.05) << seed;
    EXPECT_EQ(DesignPoint(found.point.begin() + 1, found.point.end()), (DesignPoint{3.0, 0.2, 1.0}));
    EXPECT_EQ(found.merit.cost, meritOfMixed(found.point).cost);
  }
}

TEST(GeneticSearchTest, PutsAnyAllowedPointBeforeOneThatViolates) {
  const auto merit = [](const DesignPoint& x) -> Merit {
    return {std::max(0.0, 1.0 - x[0] - x[1]), x[0] * x[0] + 2.0 * x[1] * x[1]};
  };
  NoProgress progress;
  const Fittest found = refined(unitSpace(2), merit, searchGenetically(unitSpace(2), merit, {}, 3, progress));
  EXPECT_EQ(found.merit.violation, 0.0);
  // On x + y = 1 the least is 2/3, at (2/3, 1/3).
  EXPECT_NEAR(found.merit.cost, 2.0 / 3.0, 0.02);
}

TEST(GeneticSearchTest, SameSeedSamePointAndTriesAsManyAsItSays) {
  std::size_t tried = 0;
  const auto counted = [&](const DesignPoint& point) {
    ++tried;
    return meritOfMixed(point);
  };
  GeneticSettings settings;
  settings.individuals = 11;
  settings.generations = 7;
  NoProgress progress;
  const DesignPoint first = searchGenetically(mixedSpace(), counted, settings, 4, progress).point;
  EXPECT_EQ(tried, 11U * 8U);
  EXPECT_EQ(searchGenetically(mixedSpace(), counted, settings, 4, progress).point, first);
}

TEST(GeneticSearchTest, StopsWhenCancelled) {
  CancelledProgress progress;
  EXPECT_THROW(searchGenetically(mixedSpace(), meritOfMixed, {}, 1, progress), Cancelled);
}

TEST(GeneticSearchTest, WhatIsNoNumberIsWorst) {
  EXPECT_TRUE(isBetter({1.0, 5.0}, {0.0, NAN}));
  EXPECT_FALSE(isBetter({NAN, 0.0}, {9.0, 9.0}));
  EXPECT_TRUE(isBetter({0.0, 9.0}, {0.1, -9.0}));
  EXPECT_FALSE(isBetter({0.0, 1.0}, {0.0, 1.0}));
}

TEST(RefinementTest, WalksToTheNearestLeastPointAlongEachVariable) {
  const DesignPoint start = {0.3, 1.0, 0.3, 0.0};
  const Fittest found = refined(mixedSpace(), meritOfMixed, {start, meritOfMixed(start)});
  EXPECT_NEAR(found.point[0], 1.7, 1e-5);
  EXPECT_EQ(found.point[1], 3.0);
  EXPECT_EQ(found.point[2], 0.2);
  EXPECT_EQ(found.point[3], 0.0);  // choices have no neighbours
}

}  // namespace
}  // namespace lamina
