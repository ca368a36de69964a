// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/ordering.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Point2 randomPoint(Random& random) { return {random.uniform(0, 100), random.uniform(0, 100)}; }

std::vector<RunEnds> randomRuns(Random& random, std::size_t count) {
  std::vector<RunEnds> runs(count);
  for (RunEnds& run : runs) {
    run.first = randomPoint(random);
    run.last = random.below(2) == 0 ? run.first : randomPoint(random);
  }
  return runs;
}

TEST(Ordering, RunsParallelLinesToAndFro) {
  std::vector<RunEnds> lines;
  for (const double y : {3.0, 0.0, 2.0, 1.0}) lines.push_back({{0, y}, {10, y}});
  const std::vector<OrderedRun> order = orderRuns(lines, {0, 0});
  EXPECT_DOUBLE_EQ(travelLength(lines, order, {0, 0}), 3.0);
}

TEST(Ordering, EndsNearWhereTheNozzleGoesOn) {
  // Two places as near to the start: 10 mm to the first, 20 mm to the other, and from there 10 or 30 mm on.
  const std::vector<RunEnds> runs = {{{10, 0}, {10, 0}}, {{-10, 0}, {-10, 0}}};
  EXPECT_EQ(orderRuns(runs, {0, 0}, Point2(20, 0)).back().run, 0U);
  EXPECT_EQ(orderRuns(runs, {0, 0}, Point2(-20, 0)).back().run, 1U);
}

TEST(Ordering, OfNothingIsNothing) { EXPECT_TRUE(orderRuns({}, {1, 2}).empty()); }

TEST(Ordering, CopesWithRunsInOnePlace) {
  EXPECT_EQ(orderRuns(std::vector<RunEnds>(50, {{1, 1}, {1, 1}}), {5, 5}).size(), 50U);
}

TEST(Ordering, HasEveryRunOnceAndIsTheSameEachTime) {
  EXPECT_TRUE(rc::check("any runs", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<RunEnds> runs = randomRuns(random, *rc::gen::inRange<std::size_t>(0, 200));
    const Point2 from(random.uniform(-200, 200), random.uniform(-200, 200));
    const std::vector<OrderedRun> order = orderRuns(runs, from);
    RC_ASSERT(order.size() == runs.size());
    std::vector<bool> is_seen(runs.size(), false);
    for (const OrderedRun& ordered : order) {
      RC_ASSERT(!is_seen.at(ordered.run));
      is_seen[ordered.run] = true;
    }
    const std::vector<OrderedRun> again = orderRuns(runs, from);
    for (std::size_t i = 0; i < order.size(); ++i) {
      RC_ASSERT(order[i].run == again[i].run);
      RC_ASSERT(order[i].is_reversed == again[i].is_reversed);
    }
  }));
}

/// Shortest travel of all orders, worked out by trying them.
double leastTravel(const std::vector<RunEnds>& runs, const Point2& from) {
  std::vector<OrderedRun> order(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) order[i].run = i;
  const auto earlier = [](const OrderedRun& a, const OrderedRun& b) { return a.run < b.run; };
  double least = std::numeric_limits<double>::infinity();
  do {
    for (std::size_t directions = 0; directions < (std::size_t{1} << runs.size()); ++directions) {
      for (std::size_t i = 0; i < order.size(); ++i) order[i].is_reversed = (directions >> i & 1) != 0;
      least = std::min(least, travelLength(runs, order, from));
    }
  } while (std::next_permutation(order.begin(), order.end(), earlier));
  return least;
}

TEST(Ordering, ComesNearTheShortestTravelOfFewRuns) {
  Random random(3);
  double found = 0.0;
  double least = 0.0;
  for (int i = 0; i < 30; ++i) {
    const std::vector<RunEnds> runs = randomRuns(random, 5);
    found += travelLength(runs, orderRuns(runs, {0, 0}), {0, 0});
    least += leastTravel(runs, {0, 0});
  }
  EXPECT_LT(found, 1.05 * least);
}

TEST(Ordering, OfPointsAtRandomComesNearTheKnownTourLength) {
  // [Beardwood1959]: about 0.7124 sqrt(n A) for many points; 2-opt stays within 15 % or
  // so.
  Random random(5);
  std::vector<RunEnds> points(5000);
  for (RunEnds& point : points) point.first = point.last = randomPoint(random);
  const double travel = travelLength(points, orderRuns(points, {0, 0}), {0, 0});
  EXPECT_LT(travel, 1.25 * 0.7124 * std::sqrt(5000.0 * 100 * 100));
}

}  // namespace
}  // namespace lamina
