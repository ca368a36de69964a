// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/curved_parts.hpp"

namespace lamina {
namespace {

std::vector<VertexMotion> motionsOf(const ShellSource& source) {
  return vertexMotions(source, subdivide(source.surface, 1000.0), std::nullopt);
}

/// Two rectangles that meet along the y axis and rise from it at `angle` to each side.
ShellSource valley(double angle) {
  const double x = std::cos(angle);
  const double z = std::sin(angle);
  return {{{{-x, 0, z}, {0, 0, 0}, {x, 0, z}, {x, 1, z}, {0, 1, 0}, {-x, 1, z}},
           {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}}},
          {}};
}

TEST(VertexMotion, OnAnEdgeBothPlanesMoveByTheDistance) {
  EXPECT_TRUE(rc::check([] {
    const double angle = *rc::gen::inRange(20, 70) * M_PI / 180.0;
    const auto motions = motionsOf(valley(angle));
    RC_ASSERT(motions[1].planes == 2);
    RC_ASSERT((motions[1].per_mm - Point3(0.0, 0.0, 1.0 / std::cos(angle))).norm() < 1e-9);
    RC_ASSERT(std::abs(motions[1].exactness - 1.0) < 1e-9);
    RC_ASSERT(motions[0].planes == 1);
    RC_ASSERT(std::abs(motions[0].per_mm.norm() - 1.0) < 1e-9);
  }));
}

TEST(VertexMotion, AlmostParallelNormalsDoNotBendThePath) {
  const auto motions = motionsOf(valley(1e-7));
  EXPECT_EQ(motions[1].planes, 1);
  EXPECT_NEAR((motions[1].per_mm - Point3::UnitZ()).norm(), 0.0, 1e-6);
}

TEST(VertexMotion, NoPathIsLongerThanFourTimesTheDistance) {
  const auto motions = motionsOf(valley(85.0 * M_PI / 180.0));
  EXPECT_NEAR(motions[1].per_mm.norm(), 4.0, 1e-9);
}

TEST(VertexMotion, OnTheBoundItStaysThere) {
  ShellSource slope = valley(M_PI / 4.0);
  const auto motions =
      vertexMotions(slope, subdivide(slope.surface, 1000.0), ShellBound{Point3::UnitZ(), std::sqrt(0.5)});
  EXPECT_NEAR((motions[2].per_mm - Point3(-std::sqrt(2.0), 0.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(motions[2].exactness, 1.0, 1e-9);
}

TEST(VertexMotion, AtAWallItStaysInTheWall) {
  ShellSource slope = valley(M_PI / 6.0);
  slope.walls = {{2, Point3::UnitX()}, {3, Point3::UnitX()}};
  const auto motions = motionsOf(slope);
  EXPECT_NEAR((motions[2].per_mm - Point3(0.0, 0.0, 1.0 / std::cos(M_PI / 6.0))).norm(), 0.0, 1e-9);
}

TEST(VertexMotion, MiddlesOfEdgesMoveAsTheirEndsDo) {
  const ShellSource source = valley(M_PI / 4.0);
  const Subdivision fine = subdivide(source.surface, 0.3);
  const auto motions = vertexMotions(source, fine, std::nullopt);
  for (std::size_t i = 0; i < fine.ends.size(); ++i) {
    const auto [first, second] = fine.ends[i];
    EXPECT_NEAR((motions[6 + i].per_mm - 0.5 * (motions[first].per_mm + motions[second].per_mm)).norm(), 0.0,
                1e-12);
    EXPECT_NEAR(motions[6 + i].exactness, 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace lamina
