// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/support_test.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

const Bead kBead{0.4, 0.2};

/// Layers whose plane rises along y by 45 deg over a bed far below.
BedPlane farBed() { return {Point3(0, M_SQRT1_2, M_SQRT1_2), -1000.0}; }

Layer layer(double bottom_mm, const Polygon& contour) {
  return {{bottom_mm, bottom_mm + 0.2}, {{contour}, {}}};
}

const Polygon kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(SupportTest, CarriesWhereAQuarterOfTheBeadLiesOnTheLayerBefore) {
  const Layer below = layer(0.0, kSquare);
  const SupportTest support_test(layer(0.2, kSquare), BelowLayer{&below}, farBed(), kBead);
  EXPECT_TRUE(support_test.carries({5, 5}));
  EXPECT_TRUE(support_test.carries({5, 10.09}));
  EXPECT_FALSE(support_test.carries({5, 10.11}));
  EXPECT_FALSE(support_test.carries({20, 5}));
}

TEST(SupportTest, CarriesWhereTheBeadTouchesTheBed) {
  // At 45 deg a bead reaches (0.2 + 0.4 / 2) / sqrt 2 mm below its waypoint; the plane is at z' = 0.2.
  const BedPlane bed{Point3(0, M_SQRT1_2, M_SQRT1_2), 0.0};
  const SupportTest support_test(layer(0.0, kSquare), BelowLayer{}, bed, kBead);
  EXPECT_TRUE(support_test.carries({3, 0.19}));
  EXPECT_FALSE(support_test.carries({3, 0.21}));
}

TEST(SupportTest, CarriesOnSupportsToo) {
  const Regions supports = {{{{20, 0}, {25, 0}, {25, 5}, {20, 5}}, {}}};
  const Layer below = layer(0.0, kSquare);
  const SupportTest support_test(layer(0.2, kSquare), BelowLayer{&below, &supports}, farBed(), kBead);
  EXPECT_TRUE(support_test.carries({5, 5}));
  EXPECT_TRUE(support_test.carries({22, 5.09}));
  EXPECT_FALSE(support_test.carries({22, 5.11}));
  // The plane at z' = 0.4 is (1000 + (y + 0.4) / sqrt 2) above the bed; a bead reaches 0.4 / sqrt 2 lower.
  EXPECT_NEAR(support_test.gapToBed({3, 7}), 1000.0 + 7.0 * M_SQRT1_2, 1e-9);
}

TEST(SupportTest, AgreesWithTheEvenOddRule) {
  EXPECT_TRUE(rc::check("rows against all edges", [](std::uint64_t seed) {
    Random random(seed);
    Polygon star;
    for (int i = 0; i < 40; ++i) {
      const double radius = random.uniform(2.0, 10.0);
      star.emplace_back(radius * std::cos(i * M_PI / 20), radius * std::sin(i * M_PI / 20));
    }
    const Layer below = layer(0.0, star);
    const SupportTest support_test(layer(0.2, star), BelowLayer{&below}, farBed(), kBead);
    const std::vector<Polygon> grown = outlines(offset(unite({star}), 0.1));
    for (int i = 0; i < 50; ++i) {
      const Point2 point(random.uniform(-11.0, 11.0), random.uniform(-11.0, 11.0));
      RC_ASSERT(support_test.carries(point) == contains(grown, point));
    }
  }));
}

}  // namespace
}  // namespace lamina
