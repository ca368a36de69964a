// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/nearest_triangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

Point3 anyPoint() {
  const auto coordinate = [] { return *rc::gen::inRange(-2000, 2001) / 100.0; };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

/// By sampling: no sample of the triangle may be nearer.
double sampledDistance(const Point3& point, const Point3& a, const Point3& b, const Point3& c) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; i + j <= 60; ++j)
      least = std::min(least, (a + i / 60.0 * (b - a) + j / 60.0 * (c - a) - point).norm());
  return least;
}

TEST(NearestTriangle, PlacesAreNearerThanEverySampleOfTheTriangle) {
  EXPECT_TRUE(rc::check([] {
    const Point3 a = anyPoint();
    const Point3 b = anyPoint();
    const Point3 c = anyPoint();
    const Point3 point = anyPoint();
    const double distance = (nearestInTriangle(point, a, b, c) - point).norm();
    const double sampled = sampledDistance(point, a, b, c);
    const double step = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()}) / 60.0;
    RC_ASSERT(distance <= sampled + 1e-9);
    RC_ASSERT(distance >= sampled - step);
  }));
}

TEST(NearestTriangle, TheTreeFindsWhatLookingAtAllFinds) {
  const Mesh sphere = makePart("sphere", {{"radius_mm", "7"}});
  const NearestTriangle tree(sphere);
  EXPECT_TRUE(rc::check([&] {
    const Point3 point = anyPoint();
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& corner : sphere.triangles)
      least = std::min(least, (nearestInTriangle(point, sphere.vertices[corner[0]],
                                                 sphere.vertices[corner[1]], sphere.vertices[corner[2]]) -
                               point)
                                  .norm());
    const NearestPlace found = tree.nearest(point);
    RC_ASSERT(std::abs(found.distance_mm - least) <= 1e-9);
    RC_ASSERT(std::abs((found.point - point).norm() - least) <= 1e-9);
  }));
}

TEST(NearestTriangle, NothingIsFoundBeyondTheBound) {
  const Mesh box = makePart("box", {});
  const NearestTriangle tree(box);
  const Point3 above(0.0, 0.0, boundingBox(box).high.z() + 5.0);
  EXPECT_FALSE(tree.nearest(above, 4.9));
  ASSERT_TRUE(tree.nearest(above, 5.1));
  EXPECT_NEAR(tree.nearest(above, 5.1)->distance_mm, 5.0, 1e-12);
}

TEST(NearestTriangle, AMeshWithoutTrianglesIsRefused) {
  const Mesh nothing;
  EXPECT_THROW(NearestTriangle{nothing}, InvalidInput);
}

}  // namespace
}  // namespace lamina
