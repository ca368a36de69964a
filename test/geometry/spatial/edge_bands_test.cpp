// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges found by their height.
#include "geometry/spatial/edge_bands.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

Regions randomStars(Random& random) {
  std::vector<Polygon> stars;
  for (int i = 0; i < 5; ++i)
    stars.push_back(test::star(random, {random.uniform(-9, 9), random.uniform(-9, 9)}, 1.0, 5.0, 11));
  return unite(stars);
}

TEST(EdgeBands, EncloseWhatTheOutlinesContain) {
  EXPECT_TRUE(rc::check("random places", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = randomStars(random);
    const EdgeBands bands(regions);
    for (int i = 0; i < 100; ++i) {
      const Point2 place(random.uniform(-16, 16), random.uniform(-16, 16));
      RC_ASSERT(bands.enclose(place) == contains(outlines(regions), place));
    }
  }));
}

TEST(EdgeBands, FindWhereALevelLineGoesInAndOut) {
  EXPECT_TRUE(rc::check("random lines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = randomStars(random);
    const double y = random.uniform(-16, 16);
    std::vector<double> stops = EdgeBands(regions).crossings(y);
    RC_ASSERT(std::is_sorted(stops.begin(), stops.end()));
    stops.insert(stops.begin(), -20.0);
    stops.push_back(20.0);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      RC_ASSERT(contains(outlines(regions), Point2(0.5 * (stops[i] + stops[i + 1]), y)) == (i % 2 == 1));
  }));
}

TEST(EdgeBands, FindWhereALineCrossesOutlines) {
  EXPECT_TRUE(rc::check("random lines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = randomStars(random);
    const Point2 from(random.uniform(-16, 16), random.uniform(-16, 16));
    const Point2 to(random.uniform(-16, 16), random.uniform(-16, 16));
    const std::vector<double> cuts = EdgeBands(regions).cuts(from, to);
    std::size_t expected = 0;
    for (const Region& region : regions)
      forEachEdge(region, [&](const BorderEdge& edge) {
        expected += areCrossing(from, to, edge.from, edge.to) ? 1U : 0U;
      });
    RC_ASSERT(cuts.size() == expected);
    for (const double at : cuts) {
      const Point2 place = from + at * (to - from);
      double least = 1.0;
      for (const Region& region : regions)
        forEachEdge(region, [&](const BorderEdge& edge) {
          least = std::min(least, (nearestOnSegment(edge.from, edge.to, place) - place).norm());
        });
      RC_ASSERT(least < 1e-9);
    }
  }));
}

TEST(EdgeBands, VisitAllEdgesWithinReach) {
  EXPECT_TRUE(rc::check("random places", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = randomStars(random);
    const EdgeBands bands(regions);
    const Point2 place(random.uniform(-16, 16), random.uniform(-16, 16));
    const double reach = random.uniform(0.0, 4.0);
    std::set<std::uint32_t> visited;
    bands.visitNear(place, reach, [&](const BorderEdge&, std::uint32_t index) { visited.insert(index); });
    std::uint32_t index = 0;
    for (const Region& region : regions)
      forEachEdge(region, [&](const BorderEdge& edge) {
        const double distance = (nearestOnSegment(edge.from, edge.to, place) - place).norm();
        RC_ASSERT(distance > reach || visited.count(index) == 1U);
        ++index;
      });
  }));
}

TEST(EdgeBands, WithoutEdgesEncloseNothing) {
  const EdgeBands none;
  EXPECT_FALSE(none.enclose({0, 0}));
  EXPECT_TRUE(none.areApartFrom({{0, 0}, {1, 1}}));
  none.visitNear({0, 0}, 1.0, [](const BorderEdge&, std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace lamina
