// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/net_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/parts/parts.hpp"
#include "support/surfaces.hpp"

namespace lamina {
namespace {

double curvatureOf(const Mesh& mesh) { return netCurvature(mesh, pairHalfEdges(mesh)); }

TEST(NetCurvature, OfAClosedSurfaceIsTwoFullTurns) {
  EXPECT_NEAR(curvatureOf(makePart("sphere")), 4.0 * M_PI, 1e-6);
  EXPECT_NEAR(curvatureOf(makePart("box")), 4.0 * M_PI, 1e-6);
}

TEST(NetCurvature, OfASurfaceThatUnrollsIsNothing) {
  const Mesh half_cylinder = test::patch(30, 10, [](double u, double v) {
    return Point3(5.0 * std::cos(M_PI * u), 5.0 * std::sin(M_PI * u), 10.0 * v);
  });
  EXPECT_NEAR(curvatureOf(half_cylinder), 0.0, 1e-9);
}

TEST(NetCurvature, OfAPatchOfASphereIsItsAreaByTheSquaredRadius) {
  // Between latitudes -0.5 and 0.5 and over one radian of longitude: 2 sin 0.5.
  const Mesh mesh = test::patch(200, 200, [](double u, double v) {
    const double latitude = v - 0.5;
    return Point3(7.0 * std::cos(latitude) * std::cos(u), 7.0 * std::cos(latitude) * std::sin(u),
                  7.0 * std::sin(latitude));
  });
  EXPECT_NEAR(curvatureOf(mesh), 2.0 * std::sin(0.5), 0.02);
}

TEST(NetCurvature, FlatWithinAToleranceGoesAsFarAsTheEquidistantMap) {
  // t / sin t = 1.15 / 0.85 at t = 1.30567.
  EXPECT_NEAR(greatestFlatCurvature(0.15), 2.0 * M_PI * (1.0 - std::cos(1.30567)), 2e-3);
  EXPECT_NEAR(greatestFlatCurvature(0.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace lamina
