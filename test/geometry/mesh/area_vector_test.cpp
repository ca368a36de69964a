// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh/area_vector.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

// A right triangle of 3 and 4 mm in the plane z = 2, one across x + y with sides of √2 and 2 mm, and a line.
Mesh threeTriangles() {
  return {{{0, 0, 2}, {3, 0, 2}, {0, 4, 2}, {1, 0, 0}, {0, 1, 0}, {0, 1, 2}, {6, 0, 2}},
          {{0, 1, 2}, {3, 4, 5}, {0, 1, 6}}};
}

TEST(AreaVector, GivesNormalAndAreaOfATriangleByItsNumber) {
  const Mesh mesh = threeTriangles();
  EXPECT_LT((triangleNormal(mesh, 0) - Point3::UnitZ()).norm(), 1e-15);
  EXPECT_NEAR(triangleArea(mesh, 0), 6.0, 1e-12);
  EXPECT_LT((triangleNormal(mesh, 1) - Point3(std::sqrt(0.5), std::sqrt(0.5), 0.0)).norm(), 1e-15);
  EXPECT_NEAR(triangleArea(mesh, 1), std::sqrt(2.0), 1e-12);
}

TEST(AreaVector, IsNothingOfATriangleThatIsALine) {
  const Mesh mesh = threeTriangles();
  EXPECT_EQ(triangleNormal(mesh, 2), Point3(Point3::Zero()));
  EXPECT_EQ(triangleArea(mesh, 2), 0.0);
}

}  // namespace
}  // namespace lamina
