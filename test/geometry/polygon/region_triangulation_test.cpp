// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/region_triangulation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "lamina/base/error.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

double areaOf(const RegionTriangulation& region, const Triangle& corner) {
  return signedArea({region.points[corner[0]], region.points[corner[1]], region.points[corner[2]]});
}

/// Fills the outlines: areas add up, none is negative, and edges with one triangle lie on the border.
void requireFills(const RegionTriangulation& region, const std::vector<Polygon>& outlines) {
  double sum = 0.0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& corner : region.triangles) {
    RC_ASSERT(areaOf(region, corner) > 0.0);
    sum += areaOf(region, corner);
    for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(corner[k], corner[(k + 1) % 3])];
  }
  RC_ASSERT(std::abs(sum - signedArea(outlines)) <= 1e-9 * sum);
  std::size_t border_edges = 0;
  for (const auto& [edge, count] : edges) {
    RC_ASSERT(count <= 2);
    if (count == 1) ++border_edges;
    if (count == 1) RC_ASSERT(edge.second < region.border.size());
  }
  RC_ASSERT(border_edges == region.border.size());
}

TEST(RegionTriangulation, FillsStarsWithHoles) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Polygon outer = test::star(random, {3, -2}, 6.0, 12.0, 5 + static_cast<int>(random.below(60)));
    const Polygon hole =
        test::reversed(test::star(random, {3, -2}, 1.0, 4.0, 3 + static_cast<int>(random.below(20))));
    requireFills(triangulated({outer, hole}, random.uniform(0.5, 3.0)), {outer, hole});
  }));
}

TEST(RegionTriangulation, TakesPointsThatAreGivenTwiceAndSpikes) {
  const Polygon plain = test::rectangle(0, 0, 10, 4);
  Polygon doubled = plain;
  doubled.insert(doubled.begin() + 2, plain[1]);
  doubled.push_back(plain[0]);
  Polygon spiked = plain;
  spiked.insert(spiked.begin() + 2, {{12, 5}, {13, 6}, {12, 5}, plain[1]});
  spiked.push_back({-3, -3});  // from the last point to the first one, and out and back from there
  spiked.insert(spiked.begin() + static_cast<std::ptrdiff_t>(spiked.size()) - 1, plain[0]);
  for (const Polygon& outline : {doubled, spiked}) {
    const RegionTriangulation region = triangulated({outline}, 1.0);
    double sum = 0.0;
    for (const Triangle& corner : region.triangles) sum += areaOf(region, corner);
    EXPECT_NEAR(sum, 40.0, 1e-9);
    for (std::size_t i = 0; i < region.border.size(); ++i) {
      const OutlinePlace& place = region.border[i];
      const Point2 expected = (1.0 - place.fraction) * outline[place.segment] +
                              place.fraction * outline[(place.segment + 1) % outline.size()];
      EXPECT_LE((region.points[i] - expected).norm(), 1e-12);
    }
  }
}

TEST(RegionTriangulation, PointsOfTheBorderKnowWhereTheyAre) {
  const std::vector<Polygon> outlines = {test::rectangle(0, 0, 10, 4),
                                         test::reversed(test::circle({5, 2}, 1, 40))};
  const RegionTriangulation region = triangulated(outlines, 0.7);
  for (std::size_t i = 0; i < region.border.size(); ++i) {
    const OutlinePlace& place = region.border[i];
    const Polygon& outline = outlines[place.outline];
    const Point2 expected = (1.0 - place.fraction) * outline[place.segment] +
                            place.fraction * outline[(place.segment + 1) % outline.size()];
    EXPECT_LE((region.points[i] - expected).norm(), 1e-12);
  }
}

TEST(RegionTriangulation, TrianglesAreAboutAsLargeAsTheStep) {
  const RegionTriangulation region = triangulated({test::rectangle(0, 0, 30, 30)}, 1.0);
  const double mean = 900.0 / static_cast<double>(region.triangles.size());
  EXPECT_NEAR(mean, std::sqrt(3.0) / 4.0, 0.15);
}

TEST(RegionTriangulation, OutlinesThatCrossThemselvesAreRefused) {
  EXPECT_THROW(triangulated({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}, 1.0), InvalidInput);
  EXPECT_THROW(triangulated({{{0, 0}, {10, 10}}}, 1.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
