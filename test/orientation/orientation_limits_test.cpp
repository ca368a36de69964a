// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_limits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "support/directions.hpp"

namespace lamina {
namespace {

std::vector<double> anyLengths(std::size_t count) {
  std::vector<double> lengths;
  while (lengths.size() < count) lengths.push_back(test::anyNumber(0.0, 2.0));
  return lengths;
}

void requireTurns(const std::vector<Point3>& tool_axes, const std::vector<double>& lengths,
                  double max_deg_per_mm) {
  for (std::size_t m = 0; m < lengths.size(); ++m)
    RC_ASSERT(test::chordAngleDeg(tool_axes[m], tool_axes[(m + 1) % tool_axes.size()]) <=
              max_deg_per_mm * lengths[m] + 1e-6);
}

TEST(OrientationLimits, AnglesAreExactAlsoWhenSmall) {
  EXPECT_NEAR(angleDeg(Point3(1, 0, 0), Point3(std::cos(1e-9), std::sin(1e-9), 0)), 1e-9 * 180.0 / M_PI,
              1e-20);
  EXPECT_NEAR(leanDeg(Point3(0.6, 0.0, -0.8)), 36.869897645844, 1e-11);
  EXPECT_DOUBLE_EQ(leanDeg(Point3(0, 0, 1)), 180.0);
}

TEST(OrientationLimits, LeanIsTakenBackInItsOwnPlane) {
  const Point3 limited = withLeanLimit(Point3(0.48, 0.36, -0.8), 30.0);
  EXPECT_LE((limited - Point3(0.4, 0.3, -std::sqrt(0.75))).norm(), 1e-12);
  const Point3 inside(0.48, 0.36, -0.8);
  EXPECT_EQ(withLeanLimit(inside, 37.0), inside);
  EXPECT_LE((withLeanLimit(Point3(0, 0, 1), 90.0) - Point3(1, 0, 0)).norm(), 1e-12);
}

TEST(OrientationLimits, NoRunTurnsFasterThanItMay) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t count = *rc::gen::inRange<std::size_t>(2, 30);
    const bool is_closed = *rc::gen::arbitrary<bool>();
    const double tilt = test::anyNumber(0.0, 90.0);
    const double limit = test::anyNumber(0.1, 60.0);
    const std::vector<Point3> wanted = test::anyToolAxes(count, tilt);
    const std::vector<double> lengths = anyLengths(is_closed ? count : count - 1);
    const std::vector<Point3> tool_axes = withTurnLimit(wanted, lengths, limit);
    requireTurns(tool_axes, lengths, limit);
    for (const Point3& tool_axis : tool_axes) {
      RC_ASSERT(std::abs(tool_axis.norm() - 1.0) <= 1e-12);
      RC_ASSERT(leanDeg(tool_axis) <= tilt + 1e-9);
    }
  }));
}

TEST(OrientationLimits, ToolAxesThatTurnSlowlyEnoughStay) {
  std::vector<Point3> wanted;
  for (int i = 0; i < 20; ++i) wanted.emplace_back(std::sin(0.01 * i), 0.0, -std::cos(0.01 * i));
  const std::vector<double> lengths(19, 1.0);
  const std::vector<Point3> tool_axes = withTurnLimit(wanted, lengths, 0.6);
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_LE((tool_axes[i] - wanted[i]).norm(), 1e-12);
}

TEST(OrientationLimits, ASuddenTurnIsSpreadOverBothSides) {
  // 20 degrees at once in the middle, 2 degrees allowed a motion: 5 motions before and 5 after turn.
  std::vector<Point3> wanted(20, Point3(0, 0, -1));
  const double turn = 20.0 * M_PI / 180.0;
  std::fill(wanted.begin() + 10, wanted.end(), Point3(std::sin(turn), 0.0, -std::cos(turn)));
  const std::vector<Point3> tool_axes = withTurnLimit(wanted, std::vector<double>(19, 1.0), 2.0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double expected = std::clamp(10.0 + 2.0 * (static_cast<double>(i) - 9.5), 0.0, 20.0);
    EXPECT_NEAR(leanDeg(tool_axes[i]), expected, 1.01);
  }
  EXPECT_LE(leanDeg(tool_axes[3]), 1e-9);
  EXPECT_NEAR(leanDeg(tool_axes[16]), 20.0, 1e-9);
}

TEST(OrientationLimits, AClosedRunReturnsWithinItsLimit) {
  std::vector<Point3> wanted(40, Point3(0, 0, -1));
  std::fill(wanted.begin() + 15, wanted.begin() + 25, Point3(0.6, 0.0, -0.8));
  const std::vector<Point3> tool_axes = withTurnLimit(wanted, std::vector<double>(40, 1.0), 4.0);
  EXPECT_LE((tool_axes[0] - wanted[0]).norm(), 1e-12);
  EXPECT_NEAR(leanDeg(tool_axes[19]), leanDeg(tool_axes[20]), 4.0);
  // The plateau of 10 motions lets the tool reach all but the last degrees.
  EXPECT_GT(leanDeg(tool_axes[20]), 35.0);
}

}  // namespace
}  // namespace lamina
