// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics/band_coverage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Band band(const Point2& start, const Point2& end, double radius) {
  Band made;
  made.start = start;
  made.end = end;
  made.radius = radius;
  return made;
}

TEST(LineSpans, GapsAndOverlapsOnALineAreMeasured) {
  const std::vector<LineSpan> spans = {{0, 2}, {1, 5}, {1.5, 1.75}, {7, 9}};
  EXPECT_DOUBLE_EQ(uncovered(spans, {-1, 10}), 1 + 2 + 1);
  EXPECT_DOUBLE_EQ(uncovered(spans, {1, 4}), 0.0);
  EXPECT_DOUBLE_EQ(uncovered(spans, {5.5, 6}), 0.5);
  EXPECT_DOUBLE_EQ(coveredTwice(spans), 1.0);
  EXPECT_DOUBLE_EQ(uncovered({}, {2, 3}), 1.0);
  EXPECT_DOUBLE_EQ(coveredTwice({{0, 1}}), 0.0);
  EXPECT_DOUBLE_EQ(coveredTwice({{0, 10}, {1, 2}, {3, 4}, {3.5, 5}}), 3.0);
}

TEST(Band, CutsALineWhereItIsNearItsMiddle) {
  // Whether a point lies within half the width of the middle line is asked point by point.
  EXPECT_TRUE(rc::check("a point of the line is in the span as it is near the middle line", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const auto point = [&] { return Point2(random.uniform(-2, 2), random.uniform(-2, 2)); };
    Band one = band(point(), point(), random.uniform(0.05, 1.0));
    if (random.uniform(0, 1) < 0.2) one.end = one.start;
    if (random.uniform(0, 1) < 0.2) one.end.y() = one.start.y();
    const Point2 place = point();
    const Point2 way = one.end - one.start;
    const double at =
        way.isZero(0.0) ? 0.0 : std::clamp((place - one.start).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (one.start + at * way - place).norm();
    RC_PRE(std::abs(distance - one.radius) > 1e-9);
    const LineSpan span = spanAt(one, place.y());
    RC_ASSERT((span.from <= place.x() && place.x() <= span.to) == (distance < one.radius));
  }));
}

/// Overfill of two joined bands of 2 mm on a wide face, the second turned from the first.
LineSums joined(double turn_rad, bool cuts_joints) {
  const Point2 joint(10, 10);
  const Point2 next(std::cos(turn_rad), std::sin(turn_rad));
  Band first = band(joint - Point2(5, 0), joint, 1.0);
  Band second = band(joint, joint + 5 * next, 1.0);
  first.to_after = bisector(Point2(1, 0), next, joint);
  second.from_before = first.to_after;
  second.from_before.normal *= -1.0;
  second.from_before.offset *= -1.0;
  const FaceLines lines{0.0005, 0.001, 20000};
  return LineMeter().measure({Point2(-50, -50), Point2(70, -50), Point2(10, 70)}, lines, {0, lines.count},
                             {&first, &second}, {cuts_joints, true});
}

TEST(JoinedBands, OverlapInTheirRoundEndsOrNotAtAll) {
  // Straight on, the round ends overlap in a disc, of which the bands each have half.
  EXPECT_NEAR(joined(0.0, false).twice_mm * 0.001, M_PI, 0.01);
  EXPECT_NEAR(joined(0.0, true).twice_mm, 0.0, 1e-9);
  // Round a right angle they share a square and three quarters of a disc.
  EXPECT_NEAR(joined(M_PI / 2, false).twice_mm * 0.001, 1.0 + 0.75 * M_PI, 0.01);
  EXPECT_NEAR(joined(M_PI / 2, true).twice_mm, 0.0, 1e-9);
  // What turns back lies on itself.
  EXPECT_NEAR(joined(M_PI, true).twice_mm * 0.001, 10.0 + M_PI, 0.02);
}

TEST(JoinedBands, CoverTheSameHoweverOverlapsAreTaken) {
  for (const double turn : {0.0, 0.7, M_PI / 2, 2.0, 3.0})
    EXPECT_DOUBLE_EQ(joined(turn, true).uncovered_mm, joined(turn, false).uncovered_mm);
}

}  // namespace
}  // namespace lamina
