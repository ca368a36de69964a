// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/path_nesting.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geometry/polygon/clipper_units.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

ClipperLib::Paths paths(const std::vector<Polygon>& outlines) {
  ClipperLib::Paths result;
  for (const Polygon& outline : outlines) result.push_back(toUnits(outline));
  return result;
}

TEST(PathNesting, GivesHolesToTheRegionDirectlyRoundThemAndIslandsAfterIt) {
  const auto regions = nestPaths(
      paths({rectangle(11, 11, 12, 12), rectangle(40, 0, 50, 10), reversed(rectangle(5, 5, 25, 25)),
             rectangle(0, 0, 30, 30), reversed(rectangle(10, 10, 20, 20)), rectangle(6, 6, 24, 24)}));
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 4U);
  EXPECT_DOUBLE_EQ(area({(*regions)[0]}), 100.0);
  EXPECT_DOUBLE_EQ(area({(*regions)[1]}), 500.0);
  EXPECT_DOUBLE_EQ(area({(*regions)[2]}), 224.0);
  EXPECT_DOUBLE_EQ(area({(*regions)[3]}), 1.0);
}

TEST(PathNesting, TellsByAPointBesideTheBorderWhatTouchesIt) {
  const Polygon touching = {{0, 5}, {5, 8}, {5, 2}};  // a hole, one corner of which lies on the outline
  const auto regions = nestPaths(paths({touching, rectangle(0, 0, 30, 30)}));
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 1U);
  EXPECT_DOUBLE_EQ(area(*regions), 885.0);
}

/// A comb of 400 teeth, 1 mm wide and 2 mm apart, on a back that is 1 mm high; a hole and an island in every
/// tooth lie within one outline of many points, and boxes between teeth in none.
TEST(PathNesting, TellsWhatLiesWithinAnOutlineOfManyPoints) {
  Polygon comb = {{0, 0}, {800, 0}, {800, 1}};
  std::vector<Polygon> all;
  for (int tooth = 399; tooth >= 0; --tooth) {
    const double x = 2.0 * tooth;
    for (const Point2& corner : {Point2(x + 1, 1), Point2(x + 1, 5), Point2(x, 5), Point2(x, 1)})
      comb.push_back(corner);
    all.push_back(rectangle(x + 1.25, 2, x + 1.75, 4));
    all.push_back(reversed(rectangle(x + 0.25, 2, x + 0.75, 4)));
    all.push_back(rectangle(x + 0.4, 2.5, x + 0.6, 3.5));
  }
  all.push_back(comb);
  const auto regions = nestPaths(paths(all));
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 801U);
  double with_holes_mm2 = 0.0;
  for (const Region& region : *regions)
    if (!region.holes.empty()) with_holes_mm2 += area({region});
  EXPECT_NEAR(with_holes_mm2, 800.0 + 400.0 * (4.0 - 1.0), 1e-9);
}

TEST(PathNesting, LeavesToTheTreeWhatIsInDoubt) {
  EXPECT_FALSE(nestPaths(paths({rectangle(0, 0, 30, 30), reversed(rectangle(0, 0, 30, 30))})));
  EXPECT_FALSE(nestPaths(paths({reversed(rectangle(0, 0, 30, 30))})));
  EXPECT_FALSE(nestPaths(paths({rectangle(0, 0, 30, 30), rectangle(5, 5, 25, 25)})));
}

/// Squares on a coarse grid, so that many of them touch along edges and in corners.
ClipperLib::Paths scattered(std::mt19937& random, int count) {
  std::uniform_int_distribution<int> place(0, 40), size(1, 6);
  ClipperLib::Paths result;
  for (int i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    result.push_back(toUnits(rectangle(x, y, x + size(random), y + size(random))));
  }
  return result;
}

template <typename Result>
void executeDifference(const ClipperLib::Paths& subjects, const ClipperLib::Paths& clips, Result& result) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subjects, ClipperLib::ptSubject, true);
  clipper.AddPaths(clips, ClipperLib::ptClip, true);
  clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

TEST(PathNesting, EqualsTheTreeOfClipperPointByPoint) {
  std::mt19937 random(7);
  int nested = 0;
  for (int round = 0; round < 200; ++round) {
    const ClipperLib::Paths subjects = scattered(random, 60);
    const ClipperLib::Paths clips = scattered(random, 60);
    ClipperLib::Paths flat;
    ClipperLib::PolyTree tree;
    // Each by a clipper of its own: the second time a clipper begins outlines at other points.
    executeDifference(subjects, clips, flat);
    executeDifference(subjects, clips, tree);
    const std::optional<Regions> regions = nestPaths(flat);
    if (!regions) continue;
    ++nested;
    const Regions expected = fromTree(tree);
    ASSERT_EQ(regions->size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ((*regions)[i].outer, expected[i].outer);
      EXPECT_EQ((*regions)[i].holes, expected[i].holes);
    }
  }
  EXPECT_GT(nested, 190);
}

}  // namespace
}  // namespace lamina
