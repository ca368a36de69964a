// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "infill/pattern/gyroid.hpp"
#include "infill/pattern/gyroid_curves.hpp"
#include "infill/pattern/level_gyroid.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kCell = 6.0;
constexpr double kChordError = 0.01;

double surfaceValue(const Point3& at) {
  const Point3 phase = 2.0 * M_PI / kCell * at;
  return std::sin(phase.x()) * std::cos(phase.y()) + std::sin(phase.y()) * std::cos(phase.z()) +
         std::sin(phase.z()) * std::cos(phase.x());
}

Eigen::Isometry3d planeAt(double height) { return Eigen::Isometry3d(Eigen::Translation3d(0, 0, height)); }

Eigen::Isometry3d inclined(double angle_rad, double height) {
  return Eigen::AngleAxisd(angle_rad, Point3(1, 0.4, 0).normalized()) * planeAt(height);
}

PatternCurves curvesIn(const Eigen::Isometry3d& plane, double half_mm) {
  Box2 box;
  box.low = Point2(-half_mm, -half_mm);
  box.high = Point2(half_mm, half_mm);
  const GyroidSection section(plane, kCell, 0.0);
  if (section.isLevel()) return levelGyroidCurves(section, box, kChordError);
  return gyroidCurves(section, box, kCell / 16.0, kChordError);
}

std::vector<Polyline> allCurves(const PatternCurves& curves) {
  std::vector<Polyline> all = curves.open;
  all.insert(all.end(), curves.closed.begin(), curves.closed.end());
  return all;
}

TEST(GyroidSectionTest, IsTheSurfaceOfThePartInAnyPlane) {
  for (const double angle : {0.0, 0.35, M_PI / 4, 1.2})
    for (int k = 0; k < 17; ++k) {
      const Eigen::Isometry3d plane = inclined(angle, 0.11 + k * kCell / 17.0);
      for (const Polyline& curve : allCurves(curvesIn(plane, 10.0)))
        for (std::size_t i = 1; i < curve.size(); ++i)
          for (const double part : {0.0, 0.5}) {
            const Point2 at = curve[i] + part * (curve[i - 1] - curve[i]);
            // 0.01 mm off the surface the function is at most 0.018; where curves meet they are farther.
            EXPECT_NEAR(surfaceValue(plane * Point3(at.x(), at.y(), 0.0)), 0.0, 2.0 * kChordError * 1.9)
                << angle << " rad, cut " << k << " at " << at.transpose();
          }
    }
}

TEST(GyroidSectionTest, GivesItsValuesInRowsAndItsSlope) {
  const GyroidSection section(inclined(0.7, 1.3), kCell, 0.3);
  const std::vector<double> row = section.row({-3, 2}, 0.25, 300);
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_NEAR(row[i], section.value({-3 + 0.25 * static_cast<double>(i), 2}), 1e-12);
  const Point2 at(0.4, -1.7);
  const double step = 1e-5;
  EXPECT_NEAR(section.valueAndSlope(at).gradient.x(),
              (section.value({at.x() + step, at.y()}) - section.value({at.x() - step, at.y()})) / (2 * step),
              1e-8);
  EXPECT_NEAR(section.valueAndSlope(at).gradient.y(),
              (section.value({at.x(), at.y() + step}) - section.value({at.x(), at.y() - step})) / (2 * step),
              1e-8);
}

double lengthInSquare(const PatternCurves& curves, double half_mm) {
  const std::vector<Polygon> square{test::rectangle(-half_mm, -half_mm, half_mm, half_mm)};
  double sum = 0.0;
  for (const RunOnOutlines& piece : cutToOutlines(curves, square).open) sum += length(piece.points);
  return sum;
}

/// A level cut has two curves per cell that never close, whichever way they are found.
TEST(GyroidSectionTest, OfLevelLayersIsTheSameByGraphsAndByGrid) {
  for (int k = 0; k < 24; ++k) {
    const Eigen::Isometry3d plane =
        planeAt(k * kCell / 24.0 + 0.013) * Eigen::AngleAxisd(0.2 * k, Point3::UnitZ());
    const PatternCurves marched =
        gyroidCurves(GyroidSection(plane, kCell, 0.1), {{-9, -9}, {9, 9}}, kCell / 16.0, kChordError);
    EXPECT_TRUE(marched.closed.empty());
    const PatternCurves drawn =
        levelGyroidCurves(GyroidSection(plane, kCell, 0.1), {{-9, -9}, {9, 9}}, kChordError);
    EXPECT_NEAR(lengthInSquare(marched, 8.0) / lengthInSquare(drawn, 8.0), 1.0, 0.01) << "cut " << k;
  }
}

double lengthInCells(double height, int cells) {
  InfillRequest request = test::requestOf(kCell / gyroidCell(1.0), 0.0);
  request.pitch_mm = 1e-9;
  request.links = {LineLink::None, 0.0};
  request.part_from_plan = planeAt(height);
  double sum = 0.0;
  const Regions square{{test::rectangle(0, 0, cells * kCell, cells * kCell), {}}};
  for (const FillPath& path : gyroid(square, request)) sum += length(path.points);
  return sum / (cells * cells * kCell);
}

/// Length of a level cut in one cell, in cells. At height 0 the curves are y = -atan(sin x) + k pi: by
/// quadrature of sqrt(1 + y'²), 2.30916. The mean over heights is 2.4588 (4000 heights of 4000 chords), the
/// greatest 2.8756, where curves meet. Chords are up to 0.3 % shorter.
TEST(GyroidSectionTest, IsAsLongAsQuadratureSays) {
  EXPECT_NEAR(lengthInCells(0.0, 3), 2.30916, 0.003 * 2.31);
  double sum = 0.0;
  constexpr int kCuts = 64;
  for (int k = 0; k < kCuts; ++k) {
    const double cut = lengthInCells((k + 0.5) * kCell / kCuts, 2);
    EXPECT_GT(cut, 2.30);
    EXPECT_LT(cut, 2.88);
    sum += cut;
  }
  EXPECT_NEAR(sum / kCuts, gyroidCell(1.0), 0.005 * 2.46);
}

double distanceTo(const std::vector<Polyline>& curves, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polyline& curve : curves)
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Point2 along = curve[i] - curve[i - 1];
      const double at = std::clamp((point - curve[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (curve[i - 1] + at * along - point).norm());
    }
  return nearest;
}

/// Where the surface is steeper than 60 degrees, the next layer's curve lies less than a layer's height
/// aside, but for its curvature.
TEST(GyroidSectionTest, GoesOnFromLayerToLayer) {
  constexpr double kHeight = 0.2;
  for (int layer = 0; layer < 30; ++layer) {
    const Eigen::Isometry3d plane = planeAt(layer * kHeight);
    const std::vector<Polyline> next = curvesIn(planeAt((layer + 1) * kHeight), 8.0).open;
    const GyroidSection section(plane, kCell, 0.0);
    for (const Polyline& curve : curvesIn(plane, 7.0).open)
      for (const Point2& point : curve) {
        if (point.cwiseAbs().maxCoeff() > 7.0) continue;
        const double across = section.valueAndSlope(point).gradient.norm();
        const double rise = (surfaceValue({point.x(), point.y(), layer * kHeight + 1e-5}) -
                             surfaceValue({point.x(), point.y(), layer * kHeight - 1e-5})) /
                            2e-5;
        if (std::sqrt(3.0) * std::abs(rise) >= across) continue;
        EXPECT_LT(distanceTo(next, point), kHeight) << "layer " << layer;
      }
  }
}

}  // namespace
}  // namespace lamina
