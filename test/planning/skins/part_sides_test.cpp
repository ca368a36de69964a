// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// On which side of a part's surface places lie that follow each other.
#include "planning/skins/part_sides.hpp"

#include <gtest/gtest.h>

#include "lamina/base/random.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kNearMm = 2.0;

/// A cube of 10 mm, and one in it of 4 mm that faces inwards: a void.
Mesh hollowCube() {
  Mesh mesh = test::boxBetween({0, 0, 0}, {10, 10, 10});
  const Mesh hole = test::turnedInsideOut(test::boxBetween({3, 3, 3}, {7, 7, 7}));
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), hole.vertices.begin(), hole.vertices.end());
  for (const Triangle& corners : hole.triangles)
    mesh.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
  return mesh;
}

bool isBetween(const Point3& place, double low, double high) {
  return (place.array() > low).all() && (place.array() < high).all();
}

TEST(PartSides, KnowsLinesThatMeetNoTriangle) {
  const Mesh cube = hollowCube();
  const PartSides sides(cube);
  EXPECT_TRUE(sides.isClearBetween({1, 1, 1}, {9, 1, 9})) << "beside the void";
  EXPECT_TRUE(sides.isClearBetween({-1, -1, 9.99}, {-1, 12, 9.99})) << "outside";
  EXPECT_FALSE(sides.isClearBetween({5, 5, 9}, {5, 5, 11})) << "out through the top";
  EXPECT_FALSE(sides.isClearBetween({1, 5, 5}, {9, 5, 5})) << "through the void, the same side at both ends";
  EXPECT_FALSE(sides.isClearBetween({5, 5, 10}, {5, 6, 10})) << "along the surface";
  EXPECT_FALSE(sides.isClearBetween({5, 5, 10}, {5, 5, 9})) << "from the surface";
}

/// Steps of up to 2.6 mm, some of which are too far for one place to say anything about the next.
TEST(RowSides, SayWhatIsInsideAlongAnyWalk) {
  const Mesh cube = hollowCube();
  const PartSides sides(cube);
  RowSides rows(sides, 2, kNearMm);
  Random random(7);
  for (const std::size_t row : {0U, 1U, 0U}) {
    Point3 place(5, 5, 1);
    for (int step = 0; step < 2000; ++step) {
      const Point3 next =
          place + Point3(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
      if (isBetween(next, -2, 12)) place = next;
      EXPECT_EQ(rows.isWithin(place, row), isBetween(place, 0, 10) && !isBetween(place, 3, 7))
          << place.transpose();
    }
  }
  EXPECT_LT(rows.solidAngles(), 4500U) << "of 6000 places";
}

/// Two rows, 0.05 mm below the top and above it: each takes the solid angle at its first place.
TEST(RowSides, TakeOneSolidAngleAlongASurface) {
  const Mesh cube = hollowCube();
  const PartSides sides(cube);
  RowSides rows(sides, 2, kNearMm);
  for (int step = 0; step <= 90; ++step) {
    const double x = 0.5 + 0.1 * step;
    EXPECT_TRUE(rows.isWithin({x, 2.3, 9.95}, 0));
    EXPECT_FALSE(rows.isWithin({x, 2.3, 10.05}, 1));
  }
  EXPECT_EQ(rows.solidAngles(), 2U);
}

}  // namespace
}  // namespace lamina
