// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"
#include "lamina/optimisation/pareto.hpp"

namespace lamina {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Score feasible(std::vector<double> costs) { return {std::move(costs), 0.0}; }

TEST(ParetoTest, PutsFeasibleFrontsFirstThenLittleViolationThenWhatFailed) {
  const std::vector<Score> scores = {{},                       // failed
                                     {{0.0, 0.0}, 2.0},        // much too far off
                                     feasible({3.0, 3.0}),     // dominated
                                     {{9.0, 9.0}, 0.5},        // a little off
                                     feasible({1.0, 2.0}),     //
                                     feasible({2.0, 1.0}),     //
                                     {{0.0, 9.0}, 0.5},        //
                                     {{1.0, 1.0}, kInfinity},  // a constrained response was no number
                                     {}};
  const std::vector<Front> expected = {{4, 5}, {2}, {3, 6}, {1}, {7}, {0, 8}};
  EXPECT_EQ(frontsOf(scores), expected);
  EXPECT_EQ(paretoFront(scores), (Front{4, 5}));
}

TEST(ParetoTest, HasNoFrontWhereNothingIsFeasible) {
  EXPECT_TRUE(frontsOf({}).empty());
  EXPECT_TRUE(paretoFront({}).empty());
  EXPECT_TRUE(paretoFront({{}, {{1.0, 1.0}, 0.1}}).empty());
  EXPECT_EQ(paretoFront({{}, feasible({1.0, 1.0})}), Front{1});
}

TEST(ParetoTest, EqualScoresStandInOneFront) {
  const std::vector<Score> scores(3, feasible({1.0, 2.0}));
  EXPECT_EQ(paretoFront(scores), (Front{0, 1, 2}));
  EXPECT_EQ(crowdingOf(scores, {0, 1, 2}), (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(ParetoTest, NothingInTheFrontIsDominatedAndAllElseIs) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<Score> scores;
    for (int i = 0; i < 30; ++i)
      scores.push_back(feasible({static_cast<double>(random.below(8)), static_cast<double>(random.below(8)),
                                 static_cast<double>(random.below(8))}));
    const auto isDominated = [&](const Score& one) {
      for (const Score& other : scores) {
        bool is_never_worse = true;
        for (std::size_t i = 0; i < 3; ++i) is_never_worse &= other.costs[i] <= one.costs[i];
        if (is_never_worse && other.costs != one.costs) return true;
      }
      return false;
    };
    std::vector<bool> is_in_front(scores.size());
    for (const std::size_t i : paretoFront(scores)) is_in_front[i] = true;
    for (std::size_t i = 0; i < scores.size(); ++i) RC_ASSERT(is_in_front[i] == !isDominated(scores[i]));
  }));
}

TEST(ParetoTest, CrowdingIsTheExtentOfTheBoxBetweenTheNeighbours) {
  // Extents 10 and 4: the second has (4 - 0) / 10 + (4 - 1) / 4, the third (10 - 1) / 10 + (3 - 0) / 4.
  const std::vector<Score> scores = {feasible({0.0, 4.0}), feasible({1.0, 3.0}), feasible({4.0, 1.0}),
                                     feasible({10.0, 0.0})};
  const auto crowding = crowdingOf(scores, {0, 1, 2, 3});
  EXPECT_TRUE(std::isinf(crowding[0]));
  EXPECT_DOUBLE_EQ(crowding[1], 0.4 + 0.75);
  EXPECT_DOUBLE_EQ(crowding[2], 0.9 + 0.75);
  EXPECT_TRUE(std::isinf(crowding[3]));
}

TEST(ParetoTest, ACostThatIsTheSameEverywhereLeavesTheCrowdingAsItIs) {
  const std::vector<Score> scores = {feasible({0.0, 7.0, 4.0}), feasible({1.0, 7.0, 3.0}),
                                     feasible({4.0, 7.0, 1.0}), feasible({10.0, 7.0, 0.0})};
  EXPECT_DOUBLE_EQ(crowdingOf(scores, {0, 1, 2, 3})[1], 0.4 + 0.75);
}

TEST(ParetoTest, CrowdingOfOneCostAndOfFewScores) {
  const std::vector<Score> scores = {feasible({1.0}), feasible({3.0}), feasible({2.0}), {}, {}};
  EXPECT_TRUE(std::isinf(crowdingOf(scores, {0})[0]));
  EXPECT_EQ(crowdingOf(scores, {3, 4}), (std::vector<double>{0.0, 0.0}));
  EXPECT_TRUE(crowdingOf(scores, {}).empty());
  const auto crowding = crowdingOf(scores, {0, 1, 2});
  EXPECT_TRUE(std::isinf(crowding[0]));
  EXPECT_TRUE(std::isfinite(crowding[2]));
}

TEST(ParetoTest, HypervolumeIsTheUnionOfTheBoxesUnderTheReference) {
  // Boxes 3 x 1, 2 x 2 and 1 x 3 in a staircase.
  EXPECT_DOUBLE_EQ(hypervolume({{1.0, 3.0}, {2.0, 2.0}, {3.0, 1.0}}, {4.0, 4.0}), 6.0);
  EXPECT_DOUBLE_EQ(hypervolume({{1.0, 1.0, 1.0}, {0.0, 2.0, 2.0}}, {3.0, 3.0, 3.0}), 8.0 + 3.0 - 2.0);
  EXPECT_DOUBLE_EQ(hypervolume({{2.0}, {1.0}, {7.0}}, {4.0}), 3.0);
}

TEST(ParetoTest, WhatIsNotBetterThanTheReferenceAddsNoVolume) {
  EXPECT_EQ(hypervolume({}, {1.0, 1.0}), 0.0);
  EXPECT_EQ(hypervolume({{1.0, 0.0}, {0.5, 2.0}}, {1.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(hypervolume({{0.5, 0.5}, {-9.0, 1.0}}, {1.0, 1.0}), 0.25);
}

}  // namespace
}  // namespace lamina
