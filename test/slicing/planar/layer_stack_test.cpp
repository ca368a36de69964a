// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/layer_stack.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

SlicingSettings heights(double layer_mm, double first_mm) {
  SlicingSettings settings;
  settings.layer_height_mm = layer_mm;
  settings.first_layer_height_mm = first_mm;
  return settings;
}

TEST(LayerStack, CoversAPartOfWholeLayersExactly) {
  const auto layer_bounds = stackLayers(0.0, 20.0, heights(0.2, 0.2));
  ASSERT_EQ(layer_bounds.size(), 100U);
  EXPECT_NEAR(layer_bounds.back().top_mm, 20.0, 1e-12);
}

TEST(LayerStack, GivesTheFirstLayerItsOwnHeight) {
  const auto layer_bounds = stackLayers(-1.0, 1.0, heights(0.25, 0.5));
  ASSERT_EQ(layer_bounds.size(), 7U);
  EXPECT_DOUBLE_EQ(layer_bounds[0].bottom_mm, -1.0);
  EXPECT_DOUBLE_EQ(layer_bounds[0].top_mm, -0.5);
  EXPECT_DOUBLE_EQ(layer_bounds[6].top_mm, 1.0);
}

TEST(LayerStack, StacksWithoutGaps) {
  const auto layer_bounds = stackLayers(0.1, 37.3, heights(0.15, 0.3));
  for (std::size_t i = 1; i < layer_bounds.size(); ++i)
    EXPECT_NEAR(layer_bounds[i].bottom_mm, layer_bounds[i - 1].top_mm, 1e-12);
}

TEST(LayerStack, AddsALastLayerOnlyIfMoreThanHalfOfItLiesInside) {
  EXPECT_EQ(stackLayers(0.0, 1.24, heights(0.5, 0.5)).size(), 2U);
  EXPECT_EQ(stackLayers(0.0, 1.25, heights(0.5, 0.5)).size(), 2U);
  EXPECT_EQ(stackLayers(0.0, 1.26, heights(0.5, 0.5)).size(), 3U);
}

TEST(LayerStack, CutsEveryLayerBelowTheTop) {
  for (const double top : {0.3, 0.7, 1.1, 1.3, 2.9, 7.1})
    for (const LayerBounds& bounds : stackLayers(0.0, top, heights(0.2, 0.2))) EXPECT_LT(bounds.cut(), top);
}

TEST(LayerStack, IsEmptyForAPartThinnerThanHalfTheFirstLayer) {
  EXPECT_TRUE(stackLayers(0.0, 0.1, heights(0.2, 0.2)).empty());
  EXPECT_TRUE(stackLayers(0.0, 0.0, heights(0.2, 0.2)).empty());
  EXPECT_EQ(stackLayers(0.0, 0.11, heights(0.2, 0.2)).size(), 1U);
}

TEST(LayerStack, RefusesHeightsThatAreNotPositive) {
  for (const double bad : {0.0, -0.2, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(stackLayers(0.0, 1.0, heights(bad, 0.2)), InvalidConfig);
    EXPECT_THROW(stackLayers(0.0, 1.0, heights(0.2, bad)), InvalidConfig);
  }
}

TEST(LayerStack, RefusesMoreThanTenMillionLayers) {
  EXPECT_THROW(stackLayers(0.0, 100.0, heights(1e-6, 0.2)), InvalidConfig);
}

}  // namespace
}  // namespace lamina
