// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/refill.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
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
