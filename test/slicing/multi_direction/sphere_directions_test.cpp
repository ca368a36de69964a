// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/sphere_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

bool isAmong(const std::vector<Point3>& directions, const Point3& wanted) {
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Point3& direction) { return (direction - wanted).norm() < 1e-12; });
}

// 5 n² + 1 of the 10 n² + 2 corners for n = 8, and those of the equator from both halves.
TEST(SphereDirections, HaveTheAxesAmongThem) {
  const std::vector<Point3> directions = sphereDirections(321, toRadians(90.0));
  EXPECT_GE(directions.size(), 321U);
  EXPECT_LE(directions.size(), 360U);
  for (const Point3& axis :
       {Point3(0, 0, 1), Point3(1, 0, 0), Point3(-1, 0, 0), Point3(0, 1, 0), Point3(0, -1, 0)})
    EXPECT_TRUE(isAmong(directions, axis)) << axis.transpose();
}

TEST(SphereDirections, LieEvenly) {
  const std::vector<Point3> directions = sphereDirections(321, toRadians(90.0));
  ASSERT_GE(directions.size(), 321U);
  // Each has an area of 2 pi / 321; nearest neighbours of a hexagonal grid are 8.4 deg apart.
  for (const Point3& a : directions) {
    double nearest = M_PI;
    for (const Point3& b : directions)
      if (&a != &b) nearest = std::min(nearest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    EXPECT_GT(nearest, toRadians(6.0));
    EXPECT_LT(nearest, toRadians(10.5));
    EXPECT_NEAR(a.norm(), 1.0, 1e-12);
  }
}

TEST(SphereDirections, KeepToTheTilt) {
  for (const Point3& direction : sphereDirections(321, toRadians(40.0)))
    EXPECT_GE(direction.z(), std::cos(toRadians(40.0)) - 1e-9);
  EXPECT_EQ(sphereDirections(321, 0.0).size(), 1U);
}

}  // namespace
}  // namespace lamina
