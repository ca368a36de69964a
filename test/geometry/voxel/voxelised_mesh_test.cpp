// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxelised_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/voxel/isosurface.hpp"

namespace lamina {
namespace {

/// A closed voxelisedMeshBox, facing outwards.
Mesh voxelisedMeshBox(const Point3& low, const Point3& high) {
  Mesh mesh;
  for (int c = 0; c < 8; ++c)
    mesh.vertices.emplace_back((c & 1) != 0 ? high.x() : low.x(), (c & 2) != 0 ? high.y() : low.y(),
                               (c & 4) != 0 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

VoxelGrid voxelised(const Mesh& mesh, double voxel_mm) {
  NoProgress progress;
  return voxelisedMesh(mesh, voxel_mm, progress);
}

TEST(VoxelisedMesh, FillsABoxOfWholeVoxelsExactly) {
  // The middles of voxels lie on the diagonals of its faces.
  const VoxelGrid grid = voxelised(voxelisedMeshBox({0.3, -1.1, 2.7}, {9.3, 7.9, 11.7}), 0.1);
  EXPECT_EQ(grid.frame().count, (std::array<int, 3>{90, 90, 90}));
  EXPECT_EQ(grid.solidCount(), 90 * 90 * 90);
}

TEST(VoxelisedMesh, TakesAMeshThatFacesInwardsAsWell) {
  Mesh mesh = voxelisedMeshBox(Point3::Zero(), {2.0, 3.0, 4.0});
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(voxelised(mesh, 0.5).solidCount(), 4 * 6 * 8);
}

TEST(VoxelisedMesh, LeavesCavitiesOpenAndJoinsWhatOverlaps) {
  Mesh cavity = voxelisedMeshBox({1.0, 1.0, 1.0}, {2.0, 2.0, 2.0});
  for (Triangle& triangle : cavity.triangles) std::swap(triangle[0], triangle[1]);
  const Mesh outer = voxelisedMeshBox(Point3::Zero(), {4.0, 4.0, 4.0});
  EXPECT_EQ(voxelised(joined(outer, cavity), 0.5).solidCount(), 512 - 8);
  const Mesh beside = voxelisedMeshBox({2.0, 0.0, 0.0}, {6.0, 4.0, 4.0});
  EXPECT_EQ(voxelised(joined(outer, beside), 0.5).solidCount(), 512 + 256);
}

TEST(VoxelisedMesh, OfABallHasItsVolume) {
  VoxelGrid coarse({Point3::Zero(), 0.5, {44, 44, 44}});
  const auto depth = [](int i, int j, int k) { return 20.0 - (Point3(i, j, k) - Point3(22, 22, 22)).norm(); };
  for (int k = 0; k < 44; ++k)
    for (int j = 0; j < 44; ++j)
      for (int i = 0; i < 44; ++i)
        if (depth(i, j, k) > 0.0) coarse.fill(i, j, k);
  const Mesh ball = isosurface(coarse, depth);
  EXPECT_NEAR(voxelised(ball, 0.1).solidVolume(), volume(ball), 1e-3 * volume(ball));
}

TEST(VoxelisedMesh, RefusesAnOpenMesh) {
  Mesh mesh = voxelisedMeshBox(Point3::Zero(), {2.0, 3.0, 4.0});
  mesh.triangles.resize(10);
  EXPECT_THROW(voxelised(mesh, 0.5), InvalidMesh);
  EXPECT_THROW(voxelised(Mesh(), 0.5), InvalidMesh);
  EXPECT_THROW(voxelised(voxelisedMeshBox(Point3::Zero(), {2.0, 3.0, 4.0}), 0.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
