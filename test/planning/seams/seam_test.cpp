// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seams/seam.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "support/shapes.hpp"

namespace lamina {
namespace {

const Polygon kSeamSquare = test::rectangle(0, 0, 10, 10);

Seam seam(SeamPlacement placement, int seed = 1, std::uint64_t layer = 0) {
  return Seam({placement, seed}, Point2(11, -1), layer);
}

TEST(Seam, AlignedIsTheVertexNearestToTheAnchor) {
  EXPECT_EQ(seam(SeamPlacement::Aligned).placed(kSeamSquare).front(), Point2(10, 0));
}

TEST(Seam, RearIsTheVertexFarthestBack) {
  EXPECT_EQ(seam(SeamPlacement::Rear).placed(kSeamSquare).front(), Point2(10, 10));
}

TEST(Seam, NearestIsTheVertexNearestToTheNozzle) {
  const Seam nearest = seam(SeamPlacement::Nearest);
  EXPECT_EQ(nearest.approached(kSeamSquare, {1, 8}).front(), Point2(0, 10));
  EXPECT_EQ(seam(SeamPlacement::Aligned).approached(kSeamSquare, {1, 8}), kSeamSquare);
}

/// An L: its inward corner is at (4, 4).
TEST(Seam, CornerIsAnInwardOneFirst) {
  const Polygon ell = {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
  EXPECT_EQ(seam(SeamPlacement::Corner).placed(ell).front(), Point2(4, 4));
  Polygon hole(ell.rbegin(), ell.rend());
  // Of a hole all other corners are inward ones of the material; the farthest back is that of y 10 and x 4.
  EXPECT_EQ(seam(SeamPlacement::Corner).placed(hole).front(), Point2(4, 10));
}

TEST(Seam, CornerIsTheRearmostOutwardOneElse) {
  EXPECT_EQ(seam(SeamPlacement::Corner).placed(kSeamSquare).front(), Point2(10, 10));
  Polygon shaken = kSeamSquare;
  for (Point2& point : shaken)
    if (point == Point2(0, 10)) point.y() += 1e-9;  // as rounding leaves it from layer to layer
  EXPECT_EQ(seam(SeamPlacement::Corner).placed(shaken).front(), Point2(10, 10));
}

/// A round one of 0.2 mm: each of its chords turns by 22.5 deg, and all within the arms by 90 deg.
TEST(Seam, CornerMayBeRounded) {
  Polygon loop = {{0, 0}, {10, 0}, {10, 4}, {4.2, 4}};
  for (int i = 1; i < 4; ++i) {
    const double angle = i * M_PI / 8.0;
    loop.emplace_back(4.2 - 0.2 * std::sin(angle), 4.2 - 0.2 * std::cos(angle));
  }
  loop.insert(loop.end(), {{4, 4.2}, {4, 10}, {0, 10}});
  const Point2 start = seam(SeamPlacement::Corner).placed(loop).front();
  EXPECT_NEAR((start - Point2(4.2 - 0.2 * std::sqrt(0.5), 4.2 - 0.2 * std::sqrt(0.5))).norm(), 0.0, 1e-9);
}

/// Of 72 chords of 0.87 mm each turns by 5 deg.
TEST(Seam, CornerOfASmoothLoopIsItsBack) {
  const Polygon circle = test::circle({0, 0}, 10.0, 72);
  const Point2 start = seam(SeamPlacement::Corner).placed(circle).front();
  EXPECT_GT(start.y(), 9.9) << "84.3 deg is farthest back, 85 deg the nearest vertex";
}

TEST(Seam, RandomDependsOnSeedAndLayerOnly) {
  const Polygon first = seam(SeamPlacement::Random, 1, 5).placed(kSeamSquare);
  EXPECT_EQ(seam(SeamPlacement::Random, 1, 5).placed(kSeamSquare), first);
  EXPECT_NE(seam(SeamPlacement::Random, 2, 5).placed(kSeamSquare), first);
  EXPECT_NE(seam(SeamPlacement::Random, 1, 6).placed(kSeamSquare), first);
}

TEST(Seam, LeavesTheLoopTheSameLoop) {
  EXPECT_TRUE(rc::check("for every placement", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon loop = test::star(random, {1, 2}, 1.0, 5.0, *rc::gen::inRange(3, 30));
    const int seed = *rc::gen::inRange(0, 1000);
    for (const auto placement : {SeamPlacement::Nearest, SeamPlacement::Aligned, SeamPlacement::Rear,
                                 SeamPlacement::Random, SeamPlacement::Corner}) {
      const Seam rule = seam(placement, seed);
      const Polygon placed = Seam(rule).placed(loop);
      RC_ASSERT(std::abs(signedArea(placed) - signedArea(loop)) < 1e-9);
      RC_ASSERT(std::abs(perimeter(placed) - perimeter(loop)) < 1e-9);
      RC_ASSERT(test::distanceToOutline({loop}, placed.front()) < 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
