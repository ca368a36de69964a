// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "lamina/base/random.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {
namespace {

/// A box as triangles, its middle in the origin of its frame.
MeshShape boxOfTriangles(const Point3& size) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back(
        0.5 * size.cwiseProduct(Point3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return meshShape(mesh);
}

Eigen::Isometry3d anyPose(Random& random, double reach) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const auto any = [&] { return random.uniform(-1.0, 1.0); };
  pose.translate(reach * Point3(any(), any(), any()));
  pose.rotate(Eigen::Quaterniond(any(), any(), any(), any()).normalized());
  return pose;
}

const Point3 kFlat(40.0, 60.0, 20.0);
const Point3 kSmall(10.0, 8.0, 30.0);

TEST(MeshSolid, MeetsWhatTheSolidOfItsShapeMeets) {
  const Solid solid{BoxShape{kFlat}};
  const Solid mesh{boxOfTriangles(kFlat)};
  const Solid small{BoxShape{kSmall}};
  const Solid small_mesh{boxOfTriangles(kSmall)};
  Random random(5);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Isometry3d pose = anyPose(random, 10.0);
    const Eigen::Isometry3d other = anyPose(random, 40.0);
    const bool meets = solid.meets(small, other, pose);
    EXPECT_EQ(mesh.meets(small, other, pose), meets) << i;
    EXPECT_EQ(mesh.meets(small_mesh, other, pose), meets) << i;
    met += meets ? 1 : 0;
  }
  EXPECT_GT(met, 400);
  EXPECT_LT(met, 1600);
}

TEST(MeshSolid, WhatItSwallowsIsInIt) {
  const Solid mesh{boxOfTriangles(kFlat)};
  const Solid ball{SphereShape{1.0}};
  EXPECT_TRUE(
      mesh.meets(ball, Eigen::Isometry3d(Eigen::Translation3d(3, 4, 5)), Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(
      ball.meets(mesh, Eigen::Isometry3d::Identity(), Eigen::Isometry3d(Eigen::Translation3d(3, 4, 5))));
  EXPECT_FALSE(
      mesh.meets(ball, Eigen::Isometry3d(Eigen::Translation3d(3, 4, 12)), Eigen::Isometry3d::Identity()));
}

TEST(MeshSolid, ItsHullNeverLetsPassWhatTheTrianglesMeet) {
  // A tube of many corners, more than its hull keeps.
  Mesh tube;
  constexpr std::uint32_t kAround = 400;
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (const double z : {-30.0, 30.0})
      tube.vertices.emplace_back(20.0 * std::cos(i * 2.0 * M_PI / kAround),
                                 20.0 * std::sin(i * 2.0 * M_PI / kAround), z);
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t next = (i + 1) % kAround;
    tube.triangles.push_back({2 * i, 2 * next, 2 * i + 1});
    tube.triangles.push_back({2 * next, 2 * next + 1, 2 * i + 1});
  }
  const MeshShape shape = meshShape(tube);
  EXPECT_LE(shape.hull->size(), 256U);
  EXPECT_LT(shape.margin_mm, 2.0);
  const Solid exact{shape};
  const Solid hull{grown(shape, 0.0)};
  const Solid wide{grown(shape, 5.0)};
  const Solid small{BoxShape{kSmall}};
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Isometry3d other = anyPose(random, 60.0);
    const auto meets = [&](const Solid& solid) {
      return solid.meets(small, other, Eigen::Isometry3d::Identity());
    };
    EXPECT_LE(meets(exact), meets(hull)) << i;
    EXPECT_LE(meets(hull), meets(wide)) << i;
  }
  // 4 mm beside the tube: within the wider one only.
  const Eigen::Isometry3d beside(Eigen::Translation3d(20.0 + 4.0 + 5.0, 0.0, 0.0));
  EXPECT_TRUE(wide.meets(small, beside, Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(exact.meets(small, beside, Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace lamina
