// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_seam.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "support/shapes.hpp"

namespace lamina {
namespace {

const Polygon kSquare = test::rectangle(0, 0, 10, 10);

TEST(LoopSeam, OpensALoopAtItsStartAndEndsShortOfIt) {
  const FillPath run = openedLoop(kSquare, 13.0, 2.0);
  EXPECT_FALSE(run.is_closed);
  const Polyline expected = {{10, 3}, {10, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 1}};
  EXPECT_EQ(run.points, expected);
}

TEST(LoopSeam, CutsAGapRoundACorner) {
  const FillPath run = openedLoop(kSquare, 11.0, 2.0);
  EXPECT_EQ(run.points.back(), Point2(9, 0));
}

TEST(LoopSeam, LeavesALoopClosedThatIsTooShortForItsGap) {
  const FillPath run = openedLoop(kSquare, 0.0, 20.5);
  EXPECT_TRUE(run.is_closed);
  EXPECT_EQ(run.points, kSquare);
}

TEST(LoopSeam, ShortensEveryLoopByItsGap) {
  EXPECT_TRUE(rc::check("random loops", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon loop = test::star(random, {1, 2}, 1.0, 5.0, *rc::gen::inRange(3, 30));
    const double whole = perimeter(loop);
    const double gap = random.uniform(0.01, 0.5) * whole;
    const FillPath run = openedLoop(loop, random.uniform(0.0, whole), gap);
    RC_ASSERT(std::abs(length(run.points) + gap - whole) < 1e-4);
    for (const Point2& point : run.points) RC_ASSERT(test::distanceToOutline({loop}, point) < 1e-5);
  }));
}

TEST(LoopSeam, StartsEachIslandElsewhereAtRandom) {
  const Polygon loop = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  std::set<double> starts;
  for (std::size_t i = 0; i < 4; ++i) {
    InfillRequest request;
    request.island = i / 2;
    request.layer = i % 2;
    request.settings.perimeters.seam = PerimeterSeam::Random;
    starts.insert(LoopSeam(request).startOn(loop, 0));
  }
  EXPECT_EQ(starts.size(), 4U);
}

TEST(LoopSeam, StartsWithinTheLoop) {
  EXPECT_TRUE(rc::check("random loops", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon loop = test::star(random, {1, 2}, 1.0, 5.0, 9);
    InfillRequest request;
    request.layer = random.below(100000);
    request.settings.perimeters.seam =
        random.below(2) == 0 ? PerimeterSeam::Random : PerimeterSeam::Progressive;
    const double start = LoopSeam(request).startOn(loop, 3);
    RC_ASSERT(start >= 0.0);
    RC_ASSERT(start < perimeter(loop));
  }));
}

}  // namespace
}  // namespace lamina
