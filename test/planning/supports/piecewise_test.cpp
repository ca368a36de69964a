// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Regions piece by piece against the same operations on all of them.
#include "planning/supports/piecewise.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

/// Jagged pieces, some of them within the holes of others.
Regions scattered(Random& random) {
  std::vector<Polygon> borders;
  for (int i = 0; i < 6; ++i) {
    const Point2 middle(random.uniform(-20, 20), random.uniform(-20, 20));
    borders.push_back(test::star(random, middle, 3, 8, 14));
    if (random.uniform(0, 1) < 0.5) borders.push_back(test::reversed(test::star(random, middle, 1, 2.5, 8)));
  }
  return unite(borders);
}

double areaOfDifference(const Regions& a, const Regions& b) {
  return area(difference(a, b)) + area(difference(b, a));
}

TEST(Piecewise, DifferenceIsThatOfTheWhole) {
  ASSERT_TRUE(rc::check("random pieces", [] {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
    const Regions regions = scattered(random);
    const Regions subtracted = scattered(random);
    RC_ASSERT(areaOfDifference(differenceByPieces(regions, subtracted), difference(regions, subtracted)) <
              1e-2);
  }));
}

TEST(Piecewise, GrownIsNoLessThanRoundAndNoMoreThanMitred) {
  ASSERT_TRUE(rc::check("random pieces", [] {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
    const Regions regions = scattered(random);
    const double distance = random.uniform(0.05, 1.5);
    const Regions grown = grownByPieces(regions, distance);
    RC_ASSERT(area(difference(grown, offset(regions, distance))) < 1e-2);
    RC_ASSERT(area(difference(offset(regions, distance, Join::Round), grown)) < 1e-2);
  }));
}

TEST(Piecewise, HasRoomOnlyWhereADiscFits) {
  ASSERT_TRUE(rc::check("random pieces", [] {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
    const double radius = random.uniform(0.2, 4.0);
    for (const Region& region : scattered(random))
      if (surelyHasRoom(region, radius)) RC_ASSERT(!offset({region}, -0.999 * radius, Join::Round).empty());
  }));
  const Region wide{rectangle(0, 0, 10, 4), {}};
  EXPECT_TRUE(surelyHasRoom(wide, 1.9));
  EXPECT_FALSE(surelyHasRoom(wide, 2.1));
}

TEST(Piecewise, KeepsAndDropsWholePieces) {
  const Regions pieces{
      {rectangle(0, 0, 2, 2), {}}, {rectangle(10, 0, 12, 2), {}}, {rectangle(20, 0, 22, 2), {}}};
  const Region around{rectangle(8, -2, 14, 4), {}};
  const Region ring{rectangle(18, -4, 26, 6), {test::reversed(rectangle(19, -3, 25, 5))}};
  const Regions left = differenceByPieces(pieces, {around, ring});
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].outer, pieces[0].outer);
  EXPECT_EQ(left[1].outer, pieces[2].outer) << "in the hole of what is taken away";
}

TEST(Piecewise, PutsThoseNearEachOtherTogether) {
  const Regions pieces{
      {rectangle(0, 0, 2, 2), {}}, {rectangle(3, 0, 5, 2), {}}, {rectangle(10, 0, 12, 2), {}}};
  const NeighbouringRegions groups = neighbouring(pieces, 1.5);
  EXPECT_EQ(groups.near.size(), 2U);
  EXPECT_EQ(groups.alone.size(), 1U);
}

}  // namespace
}  // namespace lamina
