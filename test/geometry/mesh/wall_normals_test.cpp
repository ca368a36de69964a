// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/wall_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kMaxLean = 60.0;

TEST(WallNormals, TheTopOfThePartIsNotTakenForAWall) {
  const Mesh box = test::boxBetween({0, 0, 0}, {20, 20, 5});
  const WallNormals walls(box, Point3::UnitZ(), kMaxLean);
  // Nearer to the top than to the side.
  EXPECT_LE((walls.at(Point3(10.0, 0.5, 5.0)) - Point3(0, -1, 0)).norm(), 1e-12);
  EXPECT_THROW(WallNormals(box, Point3(std::sqrt(1.0 / 3), std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)), 20.0),
               InvalidInput);
}

TEST(WallNormals, EdgesBetweenFacetsHaveTheMeanAndCornersNot) {
  const Mesh prism = makePart("cylinder", {{"segments", "12"}});
  const WallNormals walls(prism, Point3::UnitZ(), kMaxLean);
  for (const Point3& vertex : prism.vertices) {
    const double radius = vertex.head<2>().norm();
    if (radius < 1e-6) continue;
    const Point3 middle(vertex.x(), vertex.y(), 5.0);
    EXPECT_LE((walls.at(middle) - Point3(vertex.x(), vertex.y(), 0.0) / radius).norm(), 1e-9);
  }
  const Mesh box = test::boxBetween({0, 0, 0}, {20, 20, 5});
  const Point3 at_corner = WallNormals(box, Point3::UnitZ(), kMaxLean).at(Point3(20, 20, 2));
  EXPECT_NEAR(at_corner.cwiseAbs().maxCoeff(), 1.0, 1e-12);
}

}  // namespace
}  // namespace lamina
