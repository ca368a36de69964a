// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/unreached_surface.hpp"

#include <gtest/gtest.h>

#include "support/curved_parts.hpp"

namespace lamina {
namespace {

/// A level square of 10 mm at z = 0, facing up.
Mesh square() {
  return test::gridSurface(4, [](double u, double v) { return Point3(10.0 * u, 10.0 * v, 0.0); });
}

TEST(UnreachedSurface, FarBesideTheBorderIsNotReached) {
  Mesh mesh;
  for (const double x : {5.0, 10.5, 14.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(x, 5.0, 3.0);
    mesh.vertices.emplace_back(x + 0.3, 5.0, 3.0);
    mesh.vertices.emplace_back(x, 5.3, 3.0);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(unreached(mesh, {0, 1, 2}, square(), 1.0), (TriangleNumbers{2}));
  EXPECT_TRUE(unreached(mesh, {0, 1}, square(), 1.0).empty());
}

TEST(UnreachedSurface, APointIsReachedAsFarAsALeaningWallWouldGo) {
  const std::vector<Point3> points = {{5.0, 5.0, 9.0}, {10.9, 5.0, 0.0}, {12.0, 5.0, 1.5}, {12.0, 5.0, 0.5}};
  const std::vector<Point3> missed = unreached(points, square(), 1.0, 45.0);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_EQ(missed.front(), points.back());
}

}  // namespace
}  // namespace lamina
