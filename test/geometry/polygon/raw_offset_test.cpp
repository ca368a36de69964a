// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/raw_offset.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

const Polygon kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Polygon kCorner = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};

TEST(RawOffset, MitresCornersThatOpen) {
  EXPECT_DOUBLE_EQ(signedArea(rawOffset(kSquare, 0.5)), 25.0);
  EXPECT_EQ(rawOffset(kSquare, 0.5).size(), 4U);
}

TEST(RawOffset, CutsCornersThatCloseWhereTheEdgesMeet) {
  EXPECT_DOUBLE_EQ(signedArea(rawOffset(kSquare, -0.5)), 9.0);
  const Polygon grown = rawOffset(kCorner, 0.5);
  EXPECT_EQ(grown.size(), 6U);
  EXPECT_NE(std::find(grown.begin(), grown.end(), Point2(2.5, 2.5)), grown.end());
}

TEST(RawOffset, CutsSharpCornersSquare) {
  const Polygon needle = {{0, 0}, {10, -1}, {10, 1}};
  const Polygon grown = rawOffset(needle, 0.5);
  ASSERT_EQ(grown.size(), 4U);
  for (const Point2& point : grown) EXPECT_GT(point.x(), -1.0);
}

TEST(RawOffset, DoublesBackWhereAnEdgeIsTooShort) {
  const Polygon notched = {{0, 0}, {4, 0}, {4, 4}, {2.2, 4}, {2, 3.9}, {1.8, 4}, {0, 4}};
  const Polygon grown = rawOffset(notched, 2.0);
  EXPECT_NE(std::find(grown.begin(), grown.end(), Point2(2, 3.9)), grown.end());
}

TEST(RawOffset, ClearedOfOverlapsShrinkingUndoesGrowingOnWideShapes) {
  const Regions grown = offset({Region{kCorner, {}}}, 0.7);
  const Regions back = offset(grown, -0.7);
  EXPECT_NEAR(area(back), 12.0, 1e-3);
}

TEST(RawOffset, IgnoresRepeatedPoints) {
  const Polygon repeated = {{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
  EXPECT_EQ(rawOffset(repeated, 0.5), rawOffset(kSquare, 0.5));
  EXPECT_TRUE(rawOffset({{0, 0}, {1, 0}, {1, 0}}, 0.5).empty());
}

TEST(RawOffset, DoublesBackAtSpikesThatRoundingOpens) {
  // There and back along one line, the ends nearly on it: a mitre would be of any length.
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const Point2 way(random.uniform(-3.0, 3.0), random.uniform(1.0, 7.0));
    const Polygon spiked = {{0, 0},
                            {10, 0},
                            {10, 10},
                            {5, 10},
                            Point2(5, 10) + way,
                            Point2(5, 10) + random.uniform(0.1, 0.9) * way,
                            {0, 10}};
    for (const double delta : {-0.5, 0.5})
      for (const Point2& point : rawOffset(spiked, delta)) ASSERT_LT(point.norm(), 30.0);
  }
}

/// Distance from a point to the outline.
double distanceTo(const Polygon& polygon, const Point2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2 along = polygon[(i + 1) % polygon.size()] - a;
    const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (point - a - t * along).norm());
  }
  return least;
}

TEST(RawOffset, ClearedOfOverlapsShrinkingKeepsItsDistanceAndLosesNothing) {
  EXPECT_TRUE(rc::check("random stars", [](std::uint64_t seed) {
    Random random(seed);
    Polygon star;
    const std::size_t corners = 3 + random.below(40);
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(corners);
      star.push_back(random.uniform(2.0, 10.0) * Point2(std::cos(angle), std::sin(angle)));
    }
    const double inset = random.uniform(0.05, 2.0);
    const Regions shrunk = offset({Region{star, {}}}, -inset);
    for (const Polygon& outline : outlines(shrunk))
      for (const Point2& point : outline) RC_ASSERT(distanceTo(star, point) > inset - 1e-4);
    for (int i = 0; i < 50; ++i) {
      const Point2 point(random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0));
      // Reflex corners are mitred, or cut off at the least where a round one would run.
      const bool is_deep = contains({star}, point) && distanceTo(star, point) > 2.0 * inset + 1e-4;
      if (is_deep) RC_ASSERT(contains(outlines(shrunk), point));
    }
  }));
}

}  // namespace
}  // namespace lamina
