// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/decision.hpp"

namespace lamina {
namespace {

using Rows = std::vector<std::vector<double>>;

const Rows kFront = {{1.0, 0.2}, {0.5, 0.5}, {0.2, 1.0}};

void expectNear(const std::vector<double>& actual, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

TEST(DecisionTest, LinmapTakesTheMiddleOfAFrontOfThree) {
  const Decision decision = decide(kFront, {1.0, 1.0}, DecisionMethod::Linmap);
  expectNear(decision.indices, {1.0198, 0.7071, 1.0198}, 5e-5);
  EXPECT_EQ(decision.chosen, 1U);
}

TEST(DecisionTest, LinmapFollowsTheWeightOfTheFirstObjective) {
  const Decision decision = decide(kFront, {9.0, 1.0}, DecisionMethod::Linmap);
  expectNear(decision.indices, {3.007, 1.581, 1.166}, 5e-4);
  EXPECT_EQ(decision.chosen, 2U);
}

TEST(DecisionTest, TopsisComparesTheDistancesFromBestAndWorst) {
  // Normalised as they stand: ideal (0.2, 0.2), worst (1, 1).
  const Decision decision = decide(kFront, {1.0, 1.0}, DecisionMethod::Topsis);
  const double from_ideal = 0.3 * std::sqrt(2.0);
  const double from_worst = 0.5 * std::sqrt(2.0);
  expectNear(decision.indices, {0.5, from_worst / (from_ideal + from_worst), 0.5}, 1e-12);
  EXPECT_EQ(decision.chosen, 1U);
  // Weight 9: from the ideal 2.4, 3 * 0.3 and 0.3 together, 0.8; from the worst 0.8, 1.5 and 0.5
  // together, 2.4.
  const Decision weighted = decide(kFront, {9.0, 1.0}, DecisionMethod::Topsis);
  const double middle = std::sqrt(2.5) / (std::sqrt(2.5) + std::sqrt(0.9));
  expectNear(weighted.indices, {0.25, middle, 0.75}, 1e-12);
  EXPECT_EQ(weighted.chosen, 2U);
}

TEST(DecisionTest, ResponsesToBeMaximisedHaveTheirIdealAtTheirGreatest) {
  // 400 of 500 is a fifth short of the ideal.
  const Rows costs = {{-500.0, 1.0}, {-400.0, 0.5}};
  const Decision decision = decide(costs, {1.0, 1.0}, DecisionMethod::Linmap);
  expectNear(decision.indices, {1.0, std::hypot(0.2, 0.5)}, 1e-12);
  EXPECT_EQ(decision.chosen, 1U);
}

TEST(DecisionTest, CostsThatAreAllEqualOrZeroDoNotDecide) {
  const Rows costs = {{7.0, 0.0, 2.0}, {7.0, 0.0, 1.0}};
  for (const DecisionMethod method : {DecisionMethod::Linmap, DecisionMethod::Topsis}) {
    const Decision decision = decide(costs, {1.0, 1.0, 1.0}, method);
    EXPECT_EQ(decision.chosen, 1U);
    for (const double index : decision.indices) EXPECT_TRUE(std::isfinite(index));
  }
  const Decision same = decide(Rows{{7.0}, {7.0}}, {1.0}, DecisionMethod::Topsis);
  EXPECT_EQ(same.indices, (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(same.chosen, 0U);
  EXPECT_EQ(decide(Rows{{0.0}}, {2.0}, DecisionMethod::Linmap).indices, std::vector<double>{0.0});
}

TEST(DecisionTest, RefusesWhatCannotBeWeighed) {
  const auto method = DecisionMethod::Linmap;
  EXPECT_THROW(decide(Rows{}, {}, method), InvalidInput);
  EXPECT_THROW(decide(Rows{{1.0, 2.0}}, {1.0}, method), InvalidInput);
  EXPECT_THROW(decide(Rows{{1.0}, {NAN}}, {1.0}, method), InvalidInput);
  EXPECT_THROW(decide(Rows{{1.0}}, {-1.0}, method), InvalidConfig);
  EXPECT_THROW(decide(Rows{{1.0}}, {0.0}, method), InvalidConfig);
  EXPECT_THROW(decide(Rows{{1.0}}, {NAN}, method), InvalidConfig);
}

TEST(DecisionTest, NeitherMethodTakesWhatAnotherAlternativeDominates) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    Rows costs;
    for (int i = 0; i < 8; ++i)
      costs.push_back(
          {1.0 + static_cast<double>(random.below(10)), 1.0 + static_cast<double>(random.below(10))});
    for (const DecisionMethod method : {DecisionMethod::Linmap, DecisionMethod::Topsis}) {
      const auto& chosen = costs[decide(costs, {1.0, 3.0}, method).chosen];
      for (const auto& other : costs) RC_ASSERT(!(other[0] < chosen[0] && other[1] < chosen[1]));
    }
  }));
}

}  // namespace
}  // namespace lamina
