// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/refill.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

LayerVoids layerWith(const Polygon& outline) {
  LayerVoids layer;
  layer.pitch_mm = 0.4;
  layer.voids.push_back({{outline, {}}, signedArea(outline), VoidClass::Between});
  return layer;
}

TEST(Refill, LaysABeadAsWideAsTheVoidAlongIt) {
  const std::vector<FillPath> runs = refill(layerWith(rectangle(0, 0, 5, 0.2)), {});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].role, PathRole::GapFill);
  for (const double width : runs[0].width_mm) EXPECT_NEAR(width, 0.2, 0.01);
}

TEST(Refill, LeavesVoidsThatAreTooSmallOrTooNarrow) {
  RefillSettings settings;
  settings.least_area = 1.0;  // 0.16 mm²
  EXPECT_TRUE(refill(layerWith(rectangle(0, 0, 0.75, 0.2)), settings).empty());
  EXPECT_EQ(refill(layerWith(rectangle(0, 0, 0.85, 0.2)), settings).size(), 1U);
  settings.least_width = 0.6;  // 0.24 mm
  EXPECT_TRUE(refill(layerWith(rectangle(0, 0, 5, 0.2)), settings).empty());
}

constexpr double kLayerHeight = 0.2;

/// The layer that is nothing but these runs.
ToolpathLayer deposited(const std::vector<FillPath>& runs) {
  ToolpathLayer layer;
  layer.height_mm = layer.z_mm = kLayerHeight;
  for (const FillPath& run : runs) {
    Path path;
    path.role = run.role;
    path.is_closed = run.is_closed;
    for (const Point2& point : run.points) path.points.emplace_back(point.x(), point.y(), kLayerHeight);
    std::vector<Bead> beads;
    for (const double width : run.width_mm) beads.push_back(beadOfArea(width * kLayerHeight, kLayerHeight));
    path.bead = AlongPath<Bead>(std::move(beads));
    path.feed_mm_s = 10.0;
    layer.paths.push_back(std::move(path));
  }
  return layer;
}

TEST(Refill, CoversAWideVoid) {
  for (const Polygon& outline : {rectangle(0, 0, 5, 5), test::circle({0, 0}, 2.5, 90)}) {
    const LayerVoids filled =
        findVoids({{outline, {}}}, deposited(refill(layerWith(outline), {})), VoidMapSettings());
    EXPECT_LT(filled.uncovered_mm2, 0.01 * filled.area_mm2);
    EXPECT_LT(filled.overfill_mm2, 0.03 * filled.area_mm2);
  }
}

TEST(Refill, LaysNoBeadWiderThanOnePointSixPitches) {
  EXPECT_TRUE(rc::check("squares, discs and stars", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const double size = 0.4 * random.uniform(1.0, 50.0);
    const double kind = random.uniform(0.0, 3.0);
    const Polygon outline = kind < 1.0   ? rectangle(0, 0, size, size)
                            : kind < 2.0 ? test::circle({0, 0}, 0.5 * size, 48)
                                         : test::star(random, {0, 0}, 0.2 * size, 0.5 * size, 11);
    for (const FillPath& run : refill(layerWith(outline), {}))
      for (const double width : run.width_mm) RC_ASSERT(width <= 1.6 * 0.4 + 1e-9);
  }));
}

TEST(Refill, OfALayerWithoutVoidsOrWithoutBeadsIsNothing) {
  EXPECT_TRUE(refill({}, {}).empty());
  LayerVoids bare = layerWith(rectangle(0, 0, 5, 5));
  bare.pitch_mm = 0.0;
  EXPECT_TRUE(refill(bare, {}).empty());
}

TEST(Refill, RefusesSettingsThatAreNegative) {
  RefillSettings settings;
  settings.least_area = -1.0;
  EXPECT_THROW(refill({}, settings), InvalidInput);
}

}  // namespace
}  // namespace lamina
