// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/isosurface.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

namespace lamina {
namespace {

/// Each edge is run through once either way: closed, oriented, two triangles an edge.
bool isClosedManifold(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t n = 0; n < 3; ++n) ++runs[{triangle[n], triangle[(n + 1) % 3]}];
  for (const auto& [edge, count] : runs) {
    const auto back = runs.find({edge.second, edge.first});
    if (count != 1 || back == runs.end()) return false;
  }
  return true;
}

TEST(Isosurface, OfAnyVoxelsIsAClosedManifold) {
  EXPECT_TRUE(rc::check([] {
    VoxelGrid grid({Point3::Zero(), 1.0, {*rc::gen::inRange(1, 70), *rc::gen::inRange(1, 5), 3}});
    const auto& count = grid.frame().count;
    const int solid = *rc::gen::inRange(1, 120);
    for (int n = 0; n < solid; ++n)
      grid.fill(*rc::gen::inRange(0, count[0]), *rc::gen::inRange(0, count[1]),
                *rc::gen::inRange(0, count[2]));
    const Mesh mesh = isosurface(grid);
    RC_ASSERT(!mesh.triangles.empty());
    RC_ASSERT(isClosedManifold(mesh));
    RC_ASSERT(volume(mesh) > 0.0);
  }));
}

TEST(Isosurface, AFullRowOfWordsIsClosedAtItsEnds) {
  VoxelGrid grid({Point3::Zero(), 1.0, {128, 1, 1}});
  for (const int w : {0, 1}) grid.fillWord(w, 0, 0, ~std::uint64_t{0});
  const Mesh mesh = isosurface(grid);
  EXPECT_TRUE(isClosedManifold(mesh));
  // Half a voxel less at either end, and a rhombus of half a voxel's area in section.
  EXPECT_NEAR(volume(mesh), 127.0 * 0.5 + 2.0 * (1.0 / 12.0), 1e-9);
  EXPECT_TRUE(boundingBox(mesh).low.isApprox(Point3(0, 0, 0)));
  EXPECT_TRUE(boundingBox(mesh).high.isApprox(Point3(128, 1, 1)));
}

TEST(Isosurface, OfASphereApproachesItsVolumeAndArea) {
  const double radius = 2.0;
  const VoxelFrame frame = voxelFrame({Point3::Constant(-2.2), Point3::Constant(2.2)}, 0.1);
  const DepthInside depth = [&](int i, int j, int k) { return radius - frame.centre(i, j, k).norm(); };
  VoxelGrid inside(frame);
  for (int k = 0; k < frame.count[2]; ++k)
    for (int j = 0; j < frame.count[1]; ++j)
      for (int i = 0; i < frame.count[0]; ++i)
        if (depth(i, j, k) > 0.0) inside.fill(i, j, k);
  const Mesh mesh = isosurface(inside, depth);
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_NEAR(volume(mesh), 4.0 / 3.0 * M_PI * 8.0, 0.06);
  EXPECT_NEAR(surfaceArea(mesh), 4.0 * M_PI * 4.0, 0.1);
}

TEST(Isosurface, OfNothingIsNothing) {
  EXPECT_TRUE(isosurface(VoxelGrid({Point3::Zero(), 1.0, {3, 3, 3}})).triangles.empty());
}

}  // namespace
}  // namespace lamina
