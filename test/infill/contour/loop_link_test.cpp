// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_link.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kPitch = 0.4;

/// Circles of 5 and 5.4 mm.
LoopGraph circles() {
  const Polygon inner = test::circle({0, 0}, 5.0, 720);
  const Polygon outer = test::circle({0, 0}, 5.0 + kPitch, 720);
  std::vector<Loop> loops;
  for (const Polygon& points : {inner, outer})
    loops.emplace_back(points, std::vector<double>(points.size(), kPitch));
  return LoopGraph(std::move(loops));
}

/// The two links across, each from the inner circle to the outer one.
std::array<std::pair<Point2, Point2>, 2> linesOf(const LoopGraph& net, const LoopLink& link) {
  const Loop& a = net.loops()[link.a.loop];
  const Loop& b = net.loops()[link.b.loop];
  const bool is_alike = link.ends == LinkEnds::Alike;
  return {std::make_pair(a.pointAt(link.a.from_mm), b.pointAt(is_alike ? link.b.from_mm : link.b.to_mm)),
          std::make_pair(a.pointAt(link.a.to_mm), b.pointAt(is_alike ? link.b.to_mm : link.b.from_mm))};
}

double angleOf(const Point2& point) { return std::atan2(point.y(), point.x()); }

// [Guacheta2021, figure 3-10]: along the local normal, which on circles is the radius.
TEST(LoopLink, OfTheTangentialKindLandsAtTheNearestPoints) {
  const LoopGraph net = circles();
  const auto link = linkAt(net, {0, 3.0, 1, kPitch}, ContourLink::Tangential, {});
  ASSERT_TRUE(link);
  for (const auto& [from, to] : linesOf(net, *link)) {
    // The normal of a chord leaves the radius by up to half a 720th of the circle.
    EXPECT_NEAR(angleOf(to), angleOf(from), M_PI / 720.0 * kPitch / 5.0);
    EXPECT_NEAR((to - from).norm(), kPitch, 1e-3);
  }
  // The gap in the outer circle is longer by the ratio of the radii.
  EXPECT_NEAR(link->b.length(), link->a.length() * 5.4 / 5.0, 2.0 * 5.4 * M_PI / 720.0 * kPitch / 5.0);
}

// [Guacheta2021, figure 3-11]: across the chord of the gap.
TEST(LoopLink, OfTheAverageKindHasParallelLinksAcrossTheGap) {
  const LoopGraph net = circles();
  const auto link = linkAt(net, {0, 3.0, 1, kPitch}, ContourLink::Average, {});
  ASSERT_TRUE(link);
  const auto lines = linesOf(net, *link);
  const Point2 chord = lines[1].first - lines[0].first;
  for (const auto& [from, to] : lines) EXPECT_NEAR((to - from).dot(chord), 0.0, 1e-9);
  EXPECT_NEAR((lines[1].second - lines[0].second).norm(), chord.norm(), 1e-3);
}

TEST(LoopLink, CutsAGapNineTenthsAsLongAsTheRingsAreApart) {
  const LoopGraph net = circles();
  for (const ContourLink kind : {ContourLink::Tangential, ContourLink::Average}) {
    const auto link = linkAt(net, {0, 3.0, 1, kPitch}, kind, {});
    ASSERT_TRUE(link);
    EXPECT_NEAR(link->a.length(), 0.9 * kPitch, 1e-9);
  }
}

TEST(LoopLink, IsRefusedWhereTheOtherRingIsFar) {
  const LoopGraph net = circles();
  EXPECT_FALSE(linkAt(net, {0, 3.0, 1, 0.1}, ContourLink::Average, {}));
}

}  // namespace
}  // namespace lamina
