// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/arc_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace lamina {
namespace {

/// Chords along a circle about (3, -4).
std::vector<Point2> chordsOf(double radius_mm, double from_deg, double step_deg, int count) {
  std::vector<Point2> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = (from_deg + step_deg * i) * M_PI / 180.0;
    points.emplace_back(3.0 + radius_mm * std::cos(angle), -4.0 + radius_mm * std::sin(angle));
  }
  return points;
}

TEST(ArcFit, TakesHalfACircleAtMost) {
  const auto arc = longestArc(chordsOf(10.0, 20.0, 1.0, 360), 0, 360, 0.01);
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->last, 180U);
  EXPECT_LT((arc->centre - Point2(3.0, -4.0)).norm(), 1e-6);
  EXPECT_EQ(arc->direction, ArcDirection::CounterClockwise);
  EXPECT_EQ(longestArc(chordsOf(10.0, 20.0, -1.0, 360), 0, 360, 0.01)->direction, ArcDirection::Clockwise);
}

TEST(ArcFit, KeepsMiddlesOfChordsWithinTheTolerance) {
  // The sagitta of a chord of 10 deg on a radius of 10 mm is 10 (1 - cos 5 deg) = 0.038 mm; the circle may
  // pass through the points only.
  EXPECT_FALSE(longestArc(chordsOf(10.0, 0.0, 10.0, 18), 0, 18, 0.037));
  EXPECT_TRUE(longestArc(chordsOf(10.0, 0.0, 10.0, 18), 0, 18, 0.039));
}

TEST(ArcFit, EndsWhereTheCurveTurnsStraight) {
  std::vector<Point2> points = chordsOf(10.0, 0.0, 1.0, 90);
  for (int i = 1; i <= 5; ++i) points.push_back(points[90] + Point2(-2.0 * i, 0.0));
  const auto arc = longestArc(points, 0, points.size() - 1, 0.005);
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->last, 90U);
}

TEST(ArcFit, TakesNoLinesFewPointsSmallOrFlatArcs) {
  std::vector<Point2> line;
  for (int i = 0; i < 10; ++i) line.emplace_back(i, 2.0 * i);
  EXPECT_FALSE(longestArc(line, 0, 9, 0.1));
  EXPECT_FALSE(longestArc(chordsOf(10.0, 0.0, 2.0, 2), 0, 2, 0.01));
  EXPECT_FALSE(longestArc(chordsOf(0.4, 0.0, 5.0, 20), 0, 20, 0.01));
  EXPECT_FALSE(longestArc(chordsOf(10.0, 0.0, 1.0, 4), 0, 4, 0.01));
  EXPECT_TRUE(longestArc(chordsOf(10.0, 0.0, 1.0, 6), 0, 6, 0.01));
  EXPECT_FALSE(longestArc(chordsOf(2500.0, 0.0, 0.1, 100), 0, 100, 0.01));
}

TEST(ArcFit, TakesNoCurveThatTurnsBack) {
  const auto points = std::vector<Point2>{{0, 0}, {1, 0.1}, {2, 0}, {3, -0.1}, {4, 0}, {5, 0.1}, {6, 0}};
  EXPECT_FALSE(longestArc(points, 0, 6, 0.01));
}

RC_GTEST_PROP(ArcFitProperty, PointsAndMiddlesOfChordsLieWithinTheTolerance, ()) {
  const double tolerance_mm = 0.02;
  std::vector<Point2> points;
  double heading = 0.0;
  Point2 at(0.0, 0.0);
  for (int i = 0; i < 40; ++i) {
    points.push_back(at);
    heading += *rc::gen::inRange(-20, 120) / 1000.0;
    at += 0.5 * Point2(std::cos(heading), std::sin(heading));
  }
  for (std::size_t first = 0; first + 1 < points.size(); ++first) {
    const auto arc = longestArc(points, first, points.size() - 1, tolerance_mm);
    if (!arc) continue;
    const double radius = (points[first] - arc->centre).norm();
    RC_ASSERT(std::abs((points[arc->last] - arc->centre).norm() - radius) < 1e-9);
    for (std::size_t i = first; i < arc->last; ++i) {
      const Point2 middle = 0.5 * (points[i] + points[i + 1]);
      RC_ASSERT(std::abs((points[i] - arc->centre).norm() - radius) <= tolerance_mm + 1e-9);
      RC_ASSERT(std::abs((middle - arc->centre).norm() - radius) <= tolerance_mm + 1e-9);
    }
  }
}

}  // namespace
}  // namespace lamina
