// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/face_polygons.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solids.hpp"

namespace lamina {
namespace {

double sumOfAreas(const FacePolygons& faces) {
  double sum = 0.0;
  for (std::uint32_t face = 0; face < faces.count(); ++face) sum += faces.area(face);
  return sum;
}

// A box of 10 x 8 x 6 mm, cut across its diagonal plane x = z + 2.
TEST(FacePolygons, AreDividedByAPlane) {
  const FacePolygons box(test::boxBetween({0, 0, 0}, {10, 8, 6}));
  EXPECT_NEAR(sumOfAreas(box), 376.0, 1e-9);
  const CuttingPlane plane{Point3(1.0, 0.0, -1.0).normalized(), 2.0 / std::sqrt(2.0)};
  const FacePolygons below = box.below(plane);
  double above = 0.0;
  for (std::uint32_t face = 0; face < box.count(); ++face) above += box.areaAbove(face, plane);
  // Below: bottom 2 x 8, top 8 x 8, side x = 0 whole, and of both ends the trapezium between 2 and 8 mm.
  EXPECT_NEAR(sumOfAreas(below), 16.0 + 64.0 + 48.0 + 2.0 * 0.5 * (2.0 + 8.0) * 6.0, 1e-9);
  EXPECT_NEAR(above, 376.0 - sumOfAreas(below), 1e-9);
}

TEST(FacePolygons, OnThePlaneAreBelowIt) {
  const FacePolygons box(test::boxBetween({0, 0, 0}, {10, 8, 6}));
  EXPECT_NEAR(sumOfAreas(box.below({Point3::UnitZ(), 6.0})), 376.0, 1e-9);
  EXPECT_NEAR(sumOfAreas(box.below({Point3::UnitZ(), 0.0})), 80.0, 1e-9);
}

TEST(FacePolygons, GiveTheirTriangles) {
  const FacePolygons below =
      FacePolygons(test::boxBetween({0, 0, 0}, {10, 8, 6})).below({Point3::UnitZ(), 3.0});
  std::vector<std::uint32_t> all;
  for (std::uint32_t face = 0; face < below.count(); ++face) all.push_back(face);
  EXPECT_NEAR(surfaceArea(below.meshOf(all)), 80.0 + 36.0 * 3.0, 1e-9);
}

}  // namespace
}  // namespace lamina
