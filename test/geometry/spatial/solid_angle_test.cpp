// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/solid_angle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kFourPi = 4.0 * M_PI;

/// Round z, 100 mm to the middle of a tube of 40 mm.
Mesh ringTube(std::uint32_t around, std::uint32_t along) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const double turn = 2.0 * M_PI * i / along;
      const double roll = 2.0 * M_PI * j / around;
      const double radius = 100.0 + 40.0 * std::cos(roll);
      mesh.vertices.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 40.0 * std::sin(roll));
    }
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t next_i = (i + 1) % along;
      const std::uint32_t next_j = (j + 1) % around;
      mesh.triangles.push_back({i * around + j, next_i * around + j, next_i * around + next_j});
      mesh.triangles.push_back({i * around + j, next_i * around + next_j, i * around + next_j});
    }
  return mesh;
}

/// Of the tube of many corners, from its middle line.
double offMiddleLine(const Point3& point) { return std::hypot(point.head<2>().norm() - 100.0, point.z()); }

Point3 pointAboutTube(Random& random) {
  return {random.uniform(-150.0, 150.0), random.uniform(-150.0, 150.0), random.uniform(-50.0, 50.0)};
}

TEST(SolidAngle, IsAllDirectionsWithinAndNoneOutside) {
  const Mesh mesh = ringTube(60, 120);
  const SolidAngle solid(mesh);
  EXPECT_NEAR(std::abs(solid.exactAt({100.0, 0.0, 3.0})), kFourPi, 1e-9);
  EXPECT_NEAR(solid.exactAt({0.0, 0.0, 0.0}), 0.0, 1e-9);  // in the hole
  Random random(3);
  std::size_t within = 0;
  for (int i = 0; i < 5000; ++i) {
    const Point3 point = pointAboutTube(random);
    const double off_mm = offMiddleLine(point);
    if (off_mm > 39.5 && off_mm < 40.0) continue;  // between the tube and its triangles
    EXPECT_EQ(solid.isWithin(point), off_mm < 40.0) << point.transpose();
    within += off_mm < 40.0 ? 1 : 0;
  }
  EXPECT_GT(within, 1000U);
}

TEST(SolidAngle, DecidesAsTriangleByTriangle) {
  EXPECT_TRUE(rc::check("of tubes turned inside out, and with triangles missing", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Mesh mesh = ringTube(3 + static_cast<std::uint32_t>(random.below(20)),
                         3 + static_cast<std::uint32_t>(random.below(30)));
    const double missing = *rc::gen::element(0.0, 0.05, 0.4);
    Mesh left = mesh;
    left.triangles.clear();
    const bool is_turned = random.below(2) == 0;
    for (Triangle triangle : mesh.triangles) {
      if (random.uniform(0.0, 1.0) < missing) continue;
      if (is_turned) std::swap(triangle[1], triangle[2]);
      left.triangles.push_back(triangle);
    }
    const SolidAngle solid(left);
    for (int i = 0; i < 50; ++i) {
      const Point3 point = pointAboutTube(random);
      const double angle = std::abs(solid.exactAt(point));
      if (std::abs(angle - 0.5 * kFourPi) < 1e-9) continue;
      RC_ASSERT(solid.isWithin(point) == (angle > 0.5 * kFourPi));
    }
  }));
}

TEST(SolidAngle, NothingIsWithinNothing) {
  const Mesh empty;
  EXPECT_FALSE(SolidAngle(empty).isWithin({0, 0, 0}));
  Mesh point;
  point.vertices = {{1, 1, 1}};
  point.triangles = {{0, 0, 0}};
  EXPECT_FALSE(SolidAngle(point).isWithin({0, 0, 0}));
  EXPECT_FALSE(SolidAngle(point).isWithin({1, 1, 1}));
}

}  // namespace
}  // namespace lamina
