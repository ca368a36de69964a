// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_smoothing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "support/directions.hpp"

namespace lamina {
namespace {

double greatestStep(const std::vector<Point3>& tool_axes, bool is_closed) {
  double greatest = is_closed ? test::chordAngleDeg(tool_axes.back(), tool_axes.front()) : 0.0;
  for (std::size_t i = 1; i < tool_axes.size(); ++i)
    greatest = std::max(greatest, test::chordAngleDeg(tool_axes[i - 1], tool_axes[i]));
  return greatest;
}

TEST(OrientationSmoothing, ConstantInputIsUnchanged) {
  const std::vector<Point3> tool_axes(7, Point3(0.6, 0.0, -0.8));
  for (const int window : {1, 3, 7, 21})
    for (const bool is_closed : {false, true})
      for (const Point3& tool_axis :
           smoothedToolAxes(tool_axes, is_closed ? Course::Closed : Course::Open, window))
        EXPECT_LE((tool_axis - tool_axes[0]).norm(), 1e-14);
}

TEST(OrientationSmoothing, AnEvenWindowIsRefused) {
  EXPECT_THROW(smoothedToolAxes({Point3(0, 0, -1)}, Course::Open, 4), InvalidConfig);
  EXPECT_THROW(smoothedToolAxes({Point3(0, 0, -1)}, Course::Open, 0), InvalidConfig);
}

TEST(OrientationSmoothing, IsTheMeanOfTheWindowRoundTheLoop) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t count = *rc::gen::inRange<std::size_t>(2, 12);
    const auto half = *rc::gen::inRange<std::size_t>(1, 20);
    const std::vector<Point3> tool_axes = test::anyToolAxes(count, 80.0);
    const std::vector<Point3> smoothed =
        smoothedToolAxes(tool_axes, Course::Closed, static_cast<int>(2 * half + 1));
    for (std::size_t i = 0; i < count; ++i) {
      Point3 sum = Point3::Zero();
      // Whole rounds more, so that no index is negative.
      for (std::size_t k = 0; k <= 2 * half; ++k) sum += tool_axes[(i + 40 * count + k - half) % count];
      RC_ASSERT((smoothed[i] - sum.normalized()).norm() <= 1e-12);
    }
  }));
}

TEST(OrientationSmoothing, TheGreatestStepDecreases) {
  std::vector<Point3> tool_axes(10, Point3(0, 0, -1));
  std::fill(tool_axes.begin() + 5, tool_axes.end(), Point3(0.6, 0.0, -0.8));
  for (const bool is_closed : {false, true}) {
    double before = greatestStep(tool_axes, is_closed);
    for (const int window : {3, 5}) {
      const double after = greatestStep(
          smoothedToolAxes(tool_axes, is_closed ? Course::Closed : Course::Open, window), is_closed);
      EXPECT_LT(after, before - 1.0);
      before = after;
    }
  }
}

TEST(OrientationSmoothing, TheLoopWraps) {
  std::vector<Point3> tool_axes(9, Point3(0, 0, -1));
  tool_axes[0] = Point3(0.6, 0.0, -0.8);
  const std::vector<Point3> smoothed = smoothedToolAxes(tool_axes, Course::Closed, 3);
  EXPECT_LE((smoothed[8] - smoothed[1]).norm(), 1e-14);
  EXPECT_GT(smoothed[8].x(), 0.1);
}

TEST(OrientationSmoothing, EndsOfAnOpenPathStay) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Point3> tool_axes = test::anyToolAxes(9, 60.0);
    const std::vector<Point3> smoothed = smoothedToolAxes(tool_axes, Course::Open, 5);
    RC_ASSERT((smoothed.front() - tool_axes.front()).norm() <= 1e-12);
    RC_ASSERT((smoothed.back() - tool_axes.back()).norm() <= 1e-12);
  }));
}

}  // namespace
}  // namespace lamina
