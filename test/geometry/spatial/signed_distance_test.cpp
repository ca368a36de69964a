// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/signed_distance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

/// Inside an upright box of 20 mm on z = 0, by its six planes; outside by the nearest place of its hull.
double insideBox(const Point3& point) {
  const Point3 beyond = (point - Point3(0.0, 0.0, 10.0)).cwiseAbs() - Point3::Constant(10.0);
  const double outside = beyond.cwiseMax(0.0).norm();
  return outside > 0.0 ? -outside : -beyond.maxCoeff();
}

// Points of a coarse grid are often nearest to edges and corners, where the sign is easily wrong.
TEST(SignedDistance, OfABoxIsThatToItsPlanesEdgesAndCorners) {
  const Mesh box = makePart("box");
  const SignedDistance distance(box);
  EXPECT_TRUE(rc::check([&] {
    const auto coordinate = [] { return *rc::gen::inRange(-30, 31) * 0.9; };
    const double x = coordinate();
    const double y = coordinate();
    const Point3 point(x, y, coordinate() + 10.0);
    RC_ASSERT(std::abs(distance.at(point).inside_mm - insideBox(point)) < 1e-9);
  }));
}

TEST(SignedDistance, InANarrowWedgeTheSignIsThatOfTheSolid) {
  const Mesh cone = makePart("cone", {{"radius_mm", "1"}, {"height_mm", "40"}, {"segments", "5"}});
  const SignedDistance distance(cone);
  EXPECT_LT(distance.at({0.0, 0.0, 40.5}).inside_mm, 0.0);
  EXPECT_GT(distance.at({0.0, 0.0, 39.5}).inside_mm, 0.0);
  EXPECT_LT(distance.at({1.5, 0.0, 0.0}).inside_mm, 0.0);
  EXPECT_LT(distance.at({1.2, 0.0, -0.5}).inside_mm, 0.0);
}

}  // namespace
}  // namespace lamina
