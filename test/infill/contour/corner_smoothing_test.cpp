// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/corner_smoothing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/random.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kStep = 0.05;

FillPath runOf(Polyline points, bool is_closed) {
  FillPath run;
  run.points = std::move(points);
  run.is_closed = is_closed;
  return run;
}

FillPath randomRun(Random& random) {
  FillPath run = runOf(test::star(random, {0, 0}, 3.0, 9.0, 20), random.uniform(0.0, 1.0) < 0.5);
  for (std::size_t i = 0; i < run.points.size(); ++i) run.width_mm.push_back(random.uniform(0.2, 0.6));
  return run;
}

/// The run as a closed outline, or out and back.
std::vector<Polygon> outlineOf(const FillPath& run) {
  Polygon outline = run.points;
  if (!run.is_closed) outline.insert(outline.end(), run.points.rbegin() + 1, run.points.rend() - 1);
  return {outline};
}

double farthestFrom(const FillPath& of, const FillPath& from) {
  double farthest = 0.0;
  for (const Point2& point : of.points)
    farthest = std::max(farthest, test::distanceToOutline(outlineOf(from), point));
  return farthest;
}

double largestTurn(const FillPath& run) {
  double largest = 0.0;
  for (std::size_t i = 1; i + 1 < run.points.size(); ++i) {
    const Point2 in = run.points[i] - run.points[i - 1];
    const Point2 out = run.points[i + 1] - run.points[i];
    largest = std::max(largest, std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))));
  }
  return largest;
}

TEST(CornerSmoothing, StaysNearTheRunAndKeepsItsEnds) {
  EXPECT_TRUE(rc::check("random runs", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const FillPath run = randomRun(random);
    const double window = random.uniform(0.05, 4.0);
    const FillPath smooth = smoothed(run, {window, kStep, 0.0});
    RC_ASSERT(smooth.is_closed == run.is_closed);
    RC_ASSERT(smooth.width_mm.size() == smooth.points.size());
    RC_ASSERT(farthestFrom(smooth, run) <= 0.56 * window);
    RC_ASSERT(farthestFrom(run, smooth) <= 0.56 * window);
    if (!run.is_closed) {
      RC_ASSERT((smooth.points.front() - run.points.front()).norm() < 1e-9);
      RC_ASSERT((smooth.points.back() - run.points.back()).norm() < 1e-9);
    }
  }));
}

TEST(CornerSmoothing, CutsARightAngleHalfAWindowBeforeAndAfterIt) {
  const FillPath corner = runOf({{0, 0}, {10, 0}, {10, 10}}, false);
  const FillPath smooth = smoothed(corner, {1.0, kStep, 0.0});
  // The monotone cubic from (9.5, 0) to (10, 0.5): along x it has the slope of the harmonic mean of 0.5 and
  // 0.5 at its start and none at its end, so its middle lies at x = 9.75 + 0.5 / 8.
  const Point2 middle(9.8125, 0.1875);
  double nearest = 1.0;
  for (const Point2& point : smooth.points) nearest = std::min(nearest, (point - middle).norm());
  EXPECT_LT(nearest, kStep);
  EXPECT_EQ(std::count_if(smooth.points.begin(), smooth.points.end(),
                          [](const Point2& point) { return (point - Point2(10, 0)).norm() < 0.2; }),
            0);
  for (const Point2& point : smooth.points) {
    EXPECT_LE(point.x(), 10.0);
    EXPECT_GE(point.y(), 0.0);
  }
  EXPECT_NEAR(smooth.points[1].x(), 9.5, 1e-9);
  EXPECT_LT(largestTurn(smooth), 0.25);
}

TEST(CornerSmoothing, LeavesTurnsOfLessThanThirtyDegrees) {
  const FillPath round = runOf(test::circle({0, 0}, 5, 13), true);  // 27.7 degrees each
  EXPECT_EQ(smoothed(round, {0.5, kStep, 0.0}).points, round.points);
  const FillPath corners = runOf(test::circle({0, 0}, 5, 11), true);  // 32.7
  EXPECT_GT(smoothed(corners, {0.5, kStep, 0.0}).points.size(), 3 * corners.points.size());
}

TEST(CornerSmoothing, TakesAsMuchOfAShortEdgeForEachOfItsCorners) {
  const FillPath steps = runOf({{0, 0}, {5, 0}, {5, 0.2}, {10, 0.2}}, false);
  const FillPath smooth = smoothed(steps, {2.0, kStep, 0.0});
  // Each window is as long as the edge between the corners.
  EXPECT_NEAR(smooth.points[1].x(), 4.9, 1e-9);
  EXPECT_NEAR(smooth.points[smooth.points.size() - 2].x(), 5.1, 1e-9);
}

TEST(CornerSmoothing, RoundsAllCornersOfAClosedRun) {
  const FillPath square = runOf(test::rectangle(0, 0, 10, 10), true);
  const FillPath smooth = smoothed(square, {1.0, kStep, 0.0});
  EXPECT_TRUE(smooth.is_closed);
  for (const Point2& corner : square.points) EXPECT_GT(test::distanceToOutline({smooth.points}, corner), 0.2);
  // In the middle of its curve, which no point need be on.
  EXPECT_LE(farthestFrom(smooth, square), 0.1875 + 1e-9);
  EXPECT_GT(farthestFrom(smooth, square), 0.15);
}

TEST(CornerSmoothing, KeepsWidthsWhereTheyWere) {
  FillPath run = runOf({{0, 0}, {10, 0}, {10, 10}}, false);
  run.width_mm = {0.4, 0.4, 0.6};
  const FillPath smooth = smoothed(run, {1.0, kStep, 0.0});
  for (std::size_t i = 1; i < smooth.points.size(); ++i) {
    const Point2 middle = 0.5 * (smooth.points[i] + smooth.points[i - 1]);
    const bool is_before = 10.0 - middle.x() > middle.y();
    EXPECT_EQ(smooth.width_mm[i], is_before ? 0.4 : 0.6) << middle.transpose();
  }
}

TEST(CornerSmoothing, LeavesDropsWhereTheyAre) {
  FillPath drops = runOf({{0, 0}, {1, 0}, {1, 1}}, false);
  drops.deposit = Deposit::Drops;
  EXPECT_EQ(smoothed(drops, {1.0, kStep, 0.0}).points, drops.points);
  EXPECT_EQ(simplified(drops, 10.0).points, drops.points);
}

TEST(Simplification, LeavesOutPointsWithinTheTolerance) {
  EXPECT_TRUE(rc::check("random runs", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    FillPath run = randomRun(random);
    run.width_mm.clear();
    const double tolerance = random.uniform(0.01, 2.0);
    const FillPath simple = simplified(run, tolerance);
    RC_ASSERT(simple.is_closed == run.is_closed);
    RC_ASSERT(farthestFrom(run, simple) <= tolerance + 1e-9);
    RC_ASSERT(simple.points.front() == run.points.front());
    if (!run.is_closed) RC_ASSERT(simple.points.back() == run.points.back());
  }));
}

TEST(Simplification, KeepsPointsWhereTheWidthChanges) {
  FillPath run = runOf({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, false);
  run.width_mm = {0.4, 0.4, 0.4, 0.5, 0.5};
  const FillPath simple = simplified(run, 0.1);
  EXPECT_EQ(simple.points, (Polyline{{0, 0}, {2, 0}, {4, 0}}));
  EXPECT_EQ(simple.width_mm, (std::vector<double>{0.4, 0.4, 0.5}));
}

}  // namespace
}  // namespace lamina
