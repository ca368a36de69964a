// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

using namespace test;

std::vector<Point2> parameterizationOf(const Mesh& mesh, double x_factor, double y_factor) {
  std::vector<Point2> parameterization;
  for (const Point3& vertex : mesh.vertices)
    parameterization.emplace_back(x_factor * vertex.x(), y_factor * vertex.y());
  return parameterization;
}

TEST(Distortion, AnExactPlanHasNone) {
  const Mesh plate = plateMesh(4, 3, 4.0, 3.0);
  const Distortion distortion = measureDistortion(plate, parameterizationOf(plate, 1.0, 1.0));
  EXPECT_NEAR(distortion.index_sum, 0.0, 1e-12);
  EXPECT_NEAR(distortion.least_stretch, 1.0, 1e-12);
  EXPECT_NEAR(distortion.greatest_stretch, 1.0, 1e-12);
  EXPECT_EQ(distortion.flipped, 0U);
}

TEST(Distortion, StretchReportsBothDirections) {
  const Mesh plate = plateMesh(4, 3, 4.0, 3.0);
  const Distortion distortion = measureDistortion(plate, parameterizationOf(plate, 2.0, 0.8));
  EXPECT_NEAR(distortion.least_stretch, 0.5, 1e-12);
  EXPECT_NEAR(distortion.greatest_stretch, 1.25, 1e-12);
}

TEST(Distortion, TheIndexComparesPerimeters) {
  const Mesh plate = plateMesh(4, 3, 4.0, 3.0);
  const Distortion twice = measureDistortion(plate, parameterizationOf(plate, 2.0, 2.0));
  EXPECT_NEAR(twice.index_mean, 1.0, 1e-12);
  EXPECT_NEAR(twice.index_sum, 24.0, 1e-12);
  // Sides of 1, 1 and sqrt(2) become 2, 1 and sqrt(5).
  const Distortion wide = measureDistortion(plate, parameterizationOf(plate, 2.0, 1.0));
  EXPECT_NEAR(wide.index_mean, (3.0 + std::sqrt(5.0)) / (2.0 + std::sqrt(2.0)) - 1.0, 1e-12);
}

TEST(Distortion, MirroredTrianglesAreCounted) {
  const Mesh plate = plateMesh(4, 3, 4.0, 3.0);
  EXPECT_EQ(measureDistortion(plate, parameterizationOf(plate, -1.0, 1.0)).flipped, 24U);
  std::vector<Point2> parameterization = parameterizationOf(plate, 1.0, 1.0);
  parameterization[6] += Point2(1.5, 0.0);  // an inner vertex, beyond its neighbour
  EXPECT_GT(measureDistortion(plate, parameterization).flipped, 0U);
}

TEST(Distortion, TrianglesThatVanishInThePlanStretchWithoutEnd) {
  const Mesh plate = plateMesh(1, 1, 1.0, 1.0);
  EXPECT_TRUE(std::isinf(measureDistortion(plate, parameterizationOf(plate, 1.0, 0.0)).greatest_stretch));
}

TEST(Distortion, TrianglesWithoutAreaStretchAsLines) {
  Mesh line;
  line.vertices = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  line.triangles = {{0, 1, 2}};
  const Distortion distortion = measureDistortion(line, {{0.0, 0.0}, {1.0, 0.0}, {0.5, -1e-12}});
  EXPECT_NEAR(distortion.greatest_stretch, 2.0, 1e-9);
  EXPECT_EQ(distortion.flipped, 0U);
}

TEST(Distortion, APlanOfAnotherSurfaceIsRefused) {
  EXPECT_THROW(measureDistortion(plateMesh(1, 1, 1.0, 1.0), {}), InvalidInput);
}

TEST(Injective, ARingIsAndARingThatOverlapsIsNot) {
  // An open ring of less or more than a full turn.
  const auto ring = [](double turn) {
    return patch(60, 2, [turn](double u, double v) {
      const double r = 10.0 - 3.0 * v;
      return Point3(r * std::cos(turn * u), r * std::sin(turn * u), 5.0 * u);
    });
  };
  const Mesh open = ring(6.0);
  const Mesh overlapping = ring(7.0);
  EXPECT_EQ(measureDistortion(overlapping, parameterizationOf(overlapping, 1.0, 1.0)).flipped, 0U);
  EXPECT_TRUE(isInjective(open, parameterizationOf(open, 1.0, 1.0)));
  EXPECT_FALSE(isInjective(overlapping, parameterizationOf(overlapping, 1.0, 1.0)));
}

TEST(Injective, HolesAreAllowed) {
  const Mesh ring = band(40, 2, [](double u, double v) {
    const double r = 10.0 - 3.0 * v;
    return Point3(r * std::cos(2.0 * M_PI * u), r * std::sin(2.0 * M_PI * u), 0.0);
  });
  EXPECT_TRUE(isInjective(ring, parameterizationOf(ring, 1.0, 1.0)));
}

TEST(Injective, ATwoFoldDiscIsNot) {
  const Mesh twice = disc(40, 2, [](double share, double angle) {
    const double r = share * (1.0 + 0.2 * std::cos(angle + 0.3));
    return Point3(r * std::cos(2.0 * angle), r * std::sin(2.0 * angle), share * angle);
  });
  EXPECT_EQ(measureDistortion(twice, parameterizationOf(twice, 1.0, 1.0)).flipped, 0U);
  EXPECT_FALSE(isInjective(twice, parameterizationOf(twice, 1.0, 1.0)));
}

}  // namespace
}  // namespace lamina
