// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/layer_alignment.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

constexpr ScaleRange kAny{0.5, 2.0};

SlicingSettings layersOf(double first_mm, double height_mm) {
  SlicingSettings slicing;
  slicing.first_layer_height_mm = first_mm;
  slicing.layer_height_mm = height_mm;
  return slicing;
}

TEST(LayerAlignment, MeasuresToTheNearestTopOfALayer) {
  const SlicingSettings slicing = layersOf(0.3, 0.2);
  EXPECT_NEAR(distanceToTops({{0.3, 1.0}, {0.5, 1.0}}, 1.0, slicing), 0.0, 1e-12);
  EXPECT_NEAR(distanceToTops({{0.58, 1.0}}, 1.0, slicing), 0.08, 1e-12);
  EXPECT_NEAR(distanceToTops({{0.1, 1.0}}, 1.0, slicing), 0.2, 1e-12);
  // Twice as thick layers end at 0.6 and 1 mm.
  EXPECT_NEAR(distanceToTops({{0.66, 2.0}}, 1.0, slicing), 0.06, 1e-12);
}

TEST(LayerAlignment, PutsASurfaceAtTheTopOfALayer) {
  const SlicingSettings slicing = layersOf(0.2, 0.2);
  const double scale = alignedScale({{10.07, 1.0}, {10.07, 1.0}}, kAny, slicing);
  EXPECT_NEAR(distanceToTops({{10.07, 1.0}}, scale, slicing), 0.0, 1e-9);
  EXPECT_NEAR(scale, 10.07 / 10.0, 1e-9);
}

TEST(LayerAlignment, FollowsTheMoreOfTheSurface) {
  const SlicingSettings slicing = layersOf(0.2, 0.2);
  const std::vector<SurfacePlace> places = {{5.05, 1.0}, {5.05, 1.0}, {5.05, 1.0}, {9.9, 1.0}};
  EXPECT_NEAR(distanceToTops({{5.05, 1.0}}, alignedScale(places, kAny, slicing), slicing), 0.0, 1e-9);
}

TEST(LayerAlignment, KeepsWithinItsRange) {
  const SlicingSettings slicing = layersOf(0.2, 0.2);
  EXPECT_NEAR(alignedScale({{10.03, 1.0}}, {0.9, 1.001}, slicing), 1.001, 1e-9);
  EXPECT_EQ(alignedScale({}, kAny, slicing), 1.0);
}

}  // namespace
}  // namespace lamina
