// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/voids/beads/void_map.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

/// So flat that a bead reaches as far as it fills.
constexpr double kHeight = 1e-4;
constexpr double kSide = 10.0;

/// Lines along y from edge to edge of the face, the first half a spacing from its side.
ToolpathLayer lines(double width, double spacing) {
  ToolpathLayer layer;
  layer.z_mm = kHeight;
  layer.height_mm = kHeight;
  for (double x = 0.5 * spacing; x < kSide; x += spacing) {
    Path path;
    path.role = PathRole::Infill;
    path.points = {{x, 0.0, kHeight}, {x, kSide, kHeight}};
    path.bead = beadOfArea(width * kHeight, kHeight);
    path.feed_mm_s = 10.0;
    layer.paths.push_back(path);
  }
  return layer;
}

double underFill(const ToolpathLayer& layer) {
  return findVoids({{rectangle(0, 0, kSide, kSide), {}}}, layer, {}).uncovered_mm2;
}

/// Of lines on each other: the round ends, beyond the face, are no part of it.
double overFill(const ToolpathLayer& layer) {
  return findVoids({{rectangle(-1, -1, kSide + 1, kSide + 1), {}}}, layer, {}).overfill_mm2;
}

// A horizontal face of 10 x 10 mm, lines 0.4 mm wide.

TEST(T9ParallelLines, EveryHalfMillimetreLeaveAFifthOpen) {
  const ToolpathLayer layer = lines(0.4, 0.5);
  EXPECT_NEAR(underFill(layer), 20.0, 0.1);
  EXPECT_NEAR(overFill(layer), 0.0, 1e-9);
}

TEST(T9ParallelLines, AsFarApartAsTheyAreWideFillTheFace) {
  const ToolpathLayer layer = lines(0.4, 0.4);
  EXPECT_NEAR(underFill(layer), 0.0, 1e-6);
  EXPECT_NEAR(overFill(layer), 0.0, 1e-6);
}

TEST(T9ParallelLines, NearerThanTheyAreWideOverlapInPairs) {
  const ToolpathLayer layer = lines(0.4, 0.35);
  ASSERT_EQ(layer.paths.size(), 29U);
  EXPECT_NEAR(underFill(layer), 0.0, 1e-6);
  // Two discs of 0.2 mm radius 0.35 mm apart overlap by a lens, half of which lies beyond the face.
  const double lens = 2 * 0.04 * std::acos(0.875) - 0.175 * std::sqrt(0.16 - 0.35 * 0.35);
  EXPECT_NEAR(overFill(layer), 28 * (0.05 * kSide + lens), 0.1);
}

TEST(T9ParallelLines, OfTheHeightOfALayerFillAVerticalFace) {
  const ToolpathLayer layer = lines(0.2, 0.2);
  EXPECT_NEAR(underFill(layer), 0.0, 1e-6);
  EXPECT_NEAR(overFill(layer), 0.0, 1e-6);
}

}  // namespace
}  // namespace lamina
