// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/curved_parts.hpp"

namespace lamina {
namespace {

/// Of the vertices of a surface that stands free, under limits.
VertexReach reachOf(const Mesh& surface, const ShellLimits& limits) {
  NoProgress progress;
  const auto motions = vertexMotions({surface, {}}, subdivide(surface, 1000.0), limits.bound);
  const NearestTriangle source(surface);
  return vertexReach({surface, motions, source}, limits, progress);
}

/// A trough along y whose section is the parabola z = x² / 2p, from x = -4 to 4 mm, facing up.
Mesh trough(double p) {
  return test::gridSurface(120, [p](double u, double v) {
    const double x = -4.0 + 8.0 * u;
    return Point3(x, 8.0 * (v - 0.5), x * x / (2.0 * p));
  });
}

// The greatest circle within a parabola z = x²/2p that touches it at x has its centre on the axis: its
// radius is the normal's length to the axis, sqrt(p² + x²).
TEST(VertexReach, InAParabolicTroughCollapsesAreTheNormalsToItsPlaneOfSymmetry) {
  ShellLimits limits;
  limits.farthest_mm = 20.0;
  const Mesh surface = trough(2.0);
  const VertexReach reach = reachOf(surface, limits);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const Point3& at = surface.vertices[i];
    if (std::abs(at.x()) > 3.0 || std::abs(at.y()) > 3.0) continue;
    // Slack of the ball, and where the circle fits the parabola closely it lets it grow further.
    const double radius = std::hypot(2.0, at.x());
    ASSERT_GT(reach.collapse_mm[i], 0.97 * radius);
    ASSERT_LT(reach.collapse_mm[i], 1.2 * radius);
    if (std::abs(at.x()) > 1.5) {
      ASSERT_LT(reach.collapse_mm[i], 1.05 * radius);
    }
  }
}

TEST(VertexReach, AFlatSurfaceNeverCollapses) {
  ShellLimits limits;
  limits.farthest_mm = 20.0;
  const VertexReach reach =
      reachOf(test::gridSurface(4, [](double u, double v) { return Point3(u, v, 0.0); }), limits);
  for (const double collapse : reach.collapse_mm) EXPECT_EQ(collapse, 20.0);
  for (const double exit : reach.exit_mm) EXPECT_EQ(exit, std::numeric_limits<double>::infinity());
}

TEST(VertexReach, PathsCrossABoundWhereItIs) {
  ShellLimits limits;
  limits.farthest_mm = 20.0;
  limits.bound = ShellBound{Point3::UnitZ(), 3.5};
  const VertexReach reach =
      reachOf(test::gridSurface(4, [](double u, double v) { return Point3(u, v, 1.0); }), limits);
  ASSERT_FALSE(reach.bound_mm.empty());
  for (const double bound : reach.bound_mm) EXPECT_NEAR(bound, 2.5, 1e-12);
}

TEST(VertexReach, PathsLeaveThePartThroughTheRestOfItsSurface) {
  const Mesh box = makePart("box", {{"z_mm", "7.3"}});
  const SignedDistance part(box);
  const NearestTriangle rest(box);
  ShellLimits limits;
  limits.part = &part;
  limits.rest = &rest;
  limits.farthest_mm = 20.0;
  const Mesh floor =
      test::gridSurface(8, [](double u, double v) { return Point3(-9.0 + 18.0 * u, -9.0 + 18.0 * v, 0.0); });
  const VertexReach reach = reachOf(floor, limits);
  for (const double exit : reach.exit_mm) EXPECT_NEAR(exit, 7.3, 1e-3);
}

}  // namespace
}  // namespace lamina
