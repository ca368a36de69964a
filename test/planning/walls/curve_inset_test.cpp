// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/curve_inset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slicing/adapted/plan_crossings.hpp"

namespace lamina {
namespace {

AdaptedCurve curveInsetUpright(const std::vector<Point3>& points) {
  return {true, points, std::vector<Point3>(points.size(), Point3::UnitZ()),
          std::vector<double>(points.size(), 0.2)};
}

/// On a cone whose wall leans outwards, 5 mm in radius.
AdaptedCurve leaningCircle(double lean_rad, double radius_mm, int count) {
  AdaptedCurve curve;
  for (int i = 0; i < count; ++i) {
    const double phi = 2.0 * M_PI * i / count;
    const Point3 out(std::cos(phi), std::sin(phi), 0.0);
    curve.points.push_back(radius_mm * out);
    curve.axis.push_back(std::sin(lean_rad) * out + std::cos(lean_rad) * Point3::UnitZ());
    curve.height_mm.push_back(0.2);
  }
  return curve;
}

/// Points half a millimetre apart along straight lines.
AdaptedCurve dense(const std::vector<Point3>& corners) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3 along = corners[(i + 1) % corners.size()] - corners[i];
    const int pieces = static_cast<int>(std::ceil(along.norm() / 0.5));
    for (int piece = 0; piece < pieces; ++piece)
      points.emplace_back(corners[i] + double(piece) / pieces * along);
  }
  return curveInsetUpright(points);
}

TEST(CurveInset, CornersOfASquareStaySharp) {
  const auto inset =
      insetCurve(curveInsetUpright({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}), 0.5, InsetWay::AcrossWall);
  ASSERT_EQ(inset.size(), 1U);
  ASSERT_EQ(inset[0].points.size(), 4U);
  EXPECT_LE((inset[0].points[0] - Point3(0.5, 0.5, 1)).norm(), 1e-12);
  EXPECT_LE((inset[0].points[2] - Point3(3.5, 3.5, 1)).norm(), 1e-12);
}

TEST(CurveInset, OfALeaningWallGoesAlongItsNormal) {
  const double lean = M_PI / 6.0;
  const auto inset = insetCurve(leaningCircle(lean, 5.0, 360), 0.4, InsetWay::AcrossWall);
  ASSERT_EQ(inset.size(), 1U);
  for (const Point3& point : inset[0].points) {
    EXPECT_NEAR(point.head<2>().norm(), 5.0 - 0.4 * std::cos(lean), 1e-4);
    EXPECT_NEAR(point.z(), 0.4 * std::sin(lean), 1e-4);
  }
}

TEST(CurveInset, LevelKeepsHeightAndDistance) {
  const double lean = M_PI / 6.0;
  const auto inset = insetCurve(leaningCircle(lean, 5.0, 360), 0.4, InsetWay::Level);
  ASSERT_EQ(inset.size(), 1U);
  for (const Point3& point : inset[0].points) {
    EXPECT_NEAR(point.head<2>().norm(), 5.0 - 0.4 / std::cos(lean), 1e-4);
    EXPECT_EQ(point.z(), 0.0);
  }
}

TEST(CurveInset, OfAHoleGoesAwayFromIt) {
  AdaptedCurve hole = leaningCircle(0.0, 5.0, 360);
  std::reverse(hole.points.begin(), hole.points.end());
  const auto inset = insetCurve(hole, 0.4, InsetWay::AcrossWall);
  ASSERT_EQ(inset.size(), 1U);
  for (const Point3& point : inset[0].points) EXPECT_NEAR(point.head<2>().norm(), 5.4, 1e-4);
}

TEST(CurveInset, EndsWhereASharpEdgeIsTooThin) {
  // Half a millimetre thick 5 mm from the edge at x = 10: beads 0.2 mm inside meet 0.2 / sin(half) before it.
  const double half = std::atan2(0.25, 5.0);
  const AdaptedCurve wedge = dense({{0, -0.5, 0}, {10, 0, 0}, {0, 0.5, 0}});
  const auto inset = insetCurve(wedge, 0.2, InsetWay::AcrossWall);
  ASSERT_EQ(inset.size(), 1U);
  EXPECT_TRUE(planCrossings(inset).empty());
  double farthest = 0.0;
  for (const Point3& point : inset[0].points) farthest = std::max(farthest, point.x());
  EXPECT_NEAR(farthest, 10.0 - 0.2 / std::sin(half), 1e-3);
}

TEST(CurveInset, ANeckTooNarrowLeavesTwoLoops) {
  const AdaptedCurve dumbbell = dense({{0, 0, 0},
                                       {4, 0, 0},
                                       {4, 1.85, 0},
                                       {8, 1.85, 0},
                                       {8, 0, 0},
                                       {12, 0, 0},
                                       {12, 4, 0},
                                       {7.9, 4, 0},
                                       {7.9, 2.15, 0},
                                       {4.1, 2.15, 0},
                                       {4.1, 4, 0},
                                       {0, 4, 0}});
  const auto inset = insetCurve(dumbbell, 0.2, InsetWay::AcrossWall);
  ASSERT_EQ(inset.size(), 2U);
  EXPECT_TRUE(planCrossings(inset).empty());
}

TEST(CurveInset, WhatIsTooThinAllOverIsLeftOut) {
  EXPECT_TRUE(insetCurve(leaningCircle(0.0, 0.15, 12), 0.2, InsetWay::AcrossWall).empty());
  EXPECT_TRUE(
      insetCurve(dense({{0, 0, 0}, {9, 0, 0}, {9, 0.3, 0}, {0, 0.3, 0}}), 0.2, InsetWay::AcrossWall).empty());
}

TEST(CurveInset, ByNothingIsTheCurve) {
  const AdaptedCurve circle = leaningCircle(0.3, 5.0, 12);
  EXPECT_EQ(insetCurve(circle, 0.0, InsetWay::AcrossWall).at(0).points, circle.points);
}

}  // namespace
}  // namespace lamina
