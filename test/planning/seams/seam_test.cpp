// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seams/seam.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
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

Polygon placedHere(SeamPlacement placement, const Polygon& loop, const Polygon& area) {
  const Regions here = {{area, {}}};
  Seam rule({placement, 1}, Point2(11, -1), 0, &here);
  const Polygon placed = rule.placed(loop);
  return rule.approached(placed, {9, 1});
}

constexpr std::array<SeamPlacement, 5> kEachPlacement = {SeamPlacement::Nearest, SeamPlacement::Aligned,
                                                         SeamPlacement::Rear, SeamPlacement::Random,
                                                         SeamPlacement::Corner};

TEST(SeamHere, IsTheVertexWithin) {
  for (const SeamPlacement placement : kEachPlacement) {
    const Polygon placed = placedHere(placement, kSeamSquare, test::rectangle(-1, 9, 1, 11));
    EXPECT_EQ(placed.front(), Point2(0, 10));
    EXPECT_EQ(placed.size(), 4U);
  }
}

TEST(SeamHere, ChoosesAmongVerticesWithinByItsRule) {
  const Polygon left = test::rectangle(-1, -1, 1, 11);
  EXPECT_EQ(placedHere(SeamPlacement::Aligned, kSeamSquare, left).front(), Point2(0, 0));
  EXPECT_EQ(placedHere(SeamPlacement::Rear, kSeamSquare, left).front(), Point2(0, 10));
  EXPECT_EQ(placedHere(SeamPlacement::Corner, kSeamSquare, left).front(), Point2(0, 10));
  EXPECT_EQ(placedHere(SeamPlacement::Nearest, kSeamSquare, left).front(), Point2(0, 0));
}

/// The area covers x from 2 to 5 of the lower side, and from 2 to 4 of a hole's.
TEST(SeamHere, IsTheMiddleOfTheLongestStretchWithoutAVertexThere) {
  for (const SeamPlacement placement : kEachPlacement) {
    const Polygon placed = placedHere(placement, kSeamSquare, test::rectangle(2, -1, 5, 1));
    EXPECT_LT((placed.front() - Point2(3.5, 0)).norm(), 1e-9);
    EXPECT_EQ(placed.size(), 5U);
    EXPECT_NEAR(perimeter(placed), 40.0, 1e-9);
  }
}

TEST(SeamHere, LeavesLoopsThatDoNotPass) {
  for (const SeamPlacement placement : kEachPlacement) {
    Seam usual({placement, 1}, Point2(11, -1), 0);
    const Polygon placed = placedHere(placement, kSeamSquare, test::rectangle(20, 20, 30, 30));
    EXPECT_EQ(placed, usual.approached(usual.placed(kSeamSquare), {9, 1}));
  }
}

}  // namespace
}  // namespace lamina
