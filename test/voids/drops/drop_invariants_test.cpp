// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What filling keeps, whatever the part, the strategy and the allowed overlap.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/beads/overlap_meter.hpp"
#include "lamina/voids/drops/drop_filling.hpp"
#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::filledLayer;
using test::rectangle;
using test::reversed;

struct Filling {
  std::string strategy;
  double overlap;
};

/// A plate with a hole, and two islands.
Regions partOf(Random& random) {
  return unite({test::star(random, {0, 0}, 6.0, 9.0, 18), reversed(circle({0, 0}, random.uniform(2, 4), 40)),
                test::star(random, {18, 3}, 2.0, 4.0, 9), rectangle(-20, -2, -14, 4)});
}

class DropInvariants : public testing::TestWithParam<Filling> {
 protected:
  DropVoidSettings settings() const {
    DropVoidSettings settings;
    settings.overlap = GetParam().overlap;
    settings.passes = VoidPasses::UntilFull;
    return settings;
  }
};

TEST_P(DropInvariants, HoldForPartsWithHolesAndIslands) {
  EXPECT_TRUE(rc::check("random parts", [this] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions part = partOf(random);
    const double diameter = random.uniform(0.7, 1.3);
    const DropLayer layer = filledLayer(GetParam().strategy, part, diameter, random.uniform(-2, 2));
    const std::vector<Point2> added = newDrops(fillDropVoids(layer, settings()));
    for (const Point2& drop : added) RC_ASSERT(contains(outlines(part), drop));
    const OverlapReading reading = measureOverlap(layer.drops, added, diameter);
    RC_ASSERT(reading.greatest_linear <= GetParam().overlap + 3e-6);
    RC_ASSERT(reading.greatest_area <= GetParam().overlap + 3e-6);
  }));
}

TEST_P(DropInvariants, FilledUntilFullThereIsNothingLeftToFill) {
  Random random(5);
  DropLayer layer = filledLayer(GetParam().strategy, partOf(random), 1.0, 0.3);
  const std::vector<Point2> added = newDrops(fillDropVoids(layer, settings()));
  const std::size_t begin = layer.drops.size();
  layer.drops.insert(layer.drops.end(), added.begin(), added.end());
  layer.chains.push_back({DropRole::VoidFill, begin, layer.drops.size()});
  EXPECT_TRUE(newDrops(fillDropVoids(layer, settings())).empty());
}

TEST_P(DropInvariants, AScanOfTheInsideFindsNoPlaceLeft) {
  // A plate with a round hole, and an island. What its contours of drops enclose is its inside.
  const Regions part = {{rectangle(0, 0, 14, 11), {reversed(circle({8, 5.5}, 2.3, 60))}},
                        {rectangle(17, 2, 24, 8.5), {}}};
  const DropLayer layer = filledLayer(GetParam().strategy, part, 1.0, 0.3);
  const std::vector<Polygon> inside = borders(contoursOf(layer));
  PointGrid drops(boundingBox({layer.drops}), 1.0);
  for (const Point2& drop : layer.drops) drops.insert(drop);
  for (const Point2& drop : newDrops(fillDropVoids(layer, settings()))) drops.insert(drop);
  const double least = 1.0 - GetParam().overlap + 1e-5;
  std::size_t places = 0;
  for (double y = 0.5; y <= 10.5; y += 0.05)
    for (double x = 0.5; x <= 23.5; x += 0.05) {
      if (!contains(inside, {x, y})) continue;
      ++places;
      EXPECT_TRUE(drops.hasNearer({x, y}, least)) << x << ", " << y;
    }
  // Within half a drop of the borders: 13 x 10 less a hole of radius 2.8, and 6 x 5.5.
  EXPECT_NEAR(static_cast<double>(places) * 0.05 * 0.05, 130.0 - 2.8 * 2.8 * M_PI + 33.0, 2.0);
}

std::vector<Filling> fillings() {
  std::vector<Filling> all;
  for (const char* strategy : {"drops_raster", "drops_contour", "drops_dense"})
    for (const double overlap : {0.0, 0.1, 0.2, 0.35}) all.push_back({strategy, overlap});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Drops, DropInvariants, testing::ValuesIn(fillings()),
                         [](const testing::TestParamInfo<Filling>& filling) {
                           return filling.param.strategy + "_" +
                                  std::to_string(static_cast<int>(100 * filling.param.overlap));
                         });

}  // namespace
}  // namespace lamina
