// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/start_count.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

TEST(StartCount, CountsTheRegionsWithRoomForABead) {
  const Regions regions = {{rectangle(0, 0, 10, 10), {}},
                           {rectangle(20, 0, 30, 0.3), {}},
                           {rectangle(40, 0, 50, 0.5), {}},
                           {circle({0, 50}, 10, 90), {reversed(circle({0, 50}, 9.9, 90))}}};
  EXPECT_EQ(regionsWithRoom(regions, 0.4), 2U) << "two are 0.3 mm and 0.1 mm thick";
  EXPECT_EQ(regionsWithRoom({}, 0.4), 0U);
}

TEST(StartCount, SeesRoomWhereShrinkingLeavesAnything) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions =
        unite({test::star(random, {0, 0}, 0.5, 5.0, 20), reversed(test::star(random, {0, 0}, 0.1, 0.4, 9)),
               test::star(random, {20, 0}, 0.1, 2.0, 9)});
    const double width = random.uniform(0.1, 4.0);
    std::size_t expected = 0;
    for (const Region& region : regions)
      expected += offset({region}, -0.5 * width, Join::Round).empty() ? 0 : 1;
    RC_ASSERT(regionsWithRoom(regions, width) == expected);
  }));
}

TEST(StartCount, ComparesTheTravelOfAnOrderWithTheBestThatIsFound) {
  // To and fro between two columns, where up one and down the other is shorter.
  const std::vector<RunEnds> deposited = {
      {{0, 0}, {1, 0}}, {{20, 0}, {21, 0}}, {{0, 2}, {1, 2}}, {{20, 2}, {21, 2}}};
  const FillStarts starts = startsOf({{rectangle(-1, -1, 22, 3), {}}}, deposited, 0.4);
  EXPECT_EQ(starts.runs, 4U);
  EXPECT_EQ(starts.regions, 1U);
  EXPECT_NEAR(starts.travel_mm, 19.0 + std::hypot(21.0, 2.0) + 19.0, 1e-9);
  EXPECT_NEAR(starts.best_travel_mm, 2.0 + 19.0 + 2.0, 1.1) << "up the left column, then down the right one";
}

TEST(StartCount, OfNoRunHasNoTravel) {
  const FillStarts starts = startsOf({}, {}, 0.4);
  EXPECT_EQ(starts.runs + starts.regions, 0U);
  EXPECT_EQ(starts.travel_mm, 0.0);
}

TEST(StartCount, AddsUp) {
  FillStarts sum{1, 1, 2.0, 1.5};
  sum += {3, 2, 1.0, 0.5};
  EXPECT_EQ(sum.runs, 4U);
  EXPECT_EQ(sum.regions, 3U);
  EXPECT_EQ(sum.travel_mm, 3.0);
  EXPECT_EQ(sum.best_travel_mm, 2.0);
}

}  // namespace
}  // namespace lamina
