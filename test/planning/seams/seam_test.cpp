// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seams/seam.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

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
    for (const auto placement :
         {SeamPlacement::Nearest, SeamPlacement::Aligned, SeamPlacement::Rear, SeamPlacement::Random}) {
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
