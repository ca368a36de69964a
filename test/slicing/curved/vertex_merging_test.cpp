// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/vertex_merging.hpp"

#include <gtest/gtest.h>

#include "support/curved_parts.hpp"

namespace lamina {
namespace {

/// A level strip of 4 mm in cells of 1 mm, moving up.
struct Strip {
  Mesh mesh = test::gridSurface(4, [](double u, double v) { return Point3(4.0 * u, 4.0 * v, 0.0); });
  VertexNeighbours neighbours{mesh};
  std::vector<VertexMotion> motions =
      std::vector<VertexMotion>(mesh.vertices.size(), {Point3::UnitZ(), Point3::UnitZ(), 1, 1.0});
  std::vector<double> collapse = std::vector<double>(mesh.vertices.size(), 10.0);

  MergedVertices at(double offset) const {
    return mergeCollapsed({mesh, neighbours, motions, collapse}, offset);
  }
};

TEST(VertexMerging, LivingVerticesGoTheirWay) {
  const Strip strip;
  const MergedVertices merged = strip.at(2.0);
  for (std::uint32_t i = 0; i < merged.root.size(); ++i) {
    EXPECT_EQ(merged.root[i], i);
    EXPECT_EQ(merged.place[i], Point3(strip.mesh.vertices[i] + 2.0 * Point3::UnitZ()));
    EXPECT_EQ(merged.is_stopped[i], 0);
  }
}

TEST(VertexMerging, ACollapsedVertexStopsWhereTheEdgesToItCollapse) {
  Strip strip;
  strip.collapse[12] = 1.5;  // in the middle, at (2, 2)
  for (const std::uint32_t next : strip.neighbours.of(12)) strip.collapse[next] = 2.5;
  const MergedVertices merged = strip.at(2.0);
  EXPECT_EQ(merged.root[12], 12U);
  EXPECT_EQ(merged.is_stopped[12], 1);
  // Half way on every edge to it; those of a grid with one diagonal cancel out around it.
  EXPECT_NEAR((merged.place[12] - Point3(2.0, 2.0, 2.0)).norm(), 0.0, 1e-12);
}

TEST(VertexMerging, WhatIsFarFromAnythingLivingJoinsTheNearestThatStopped) {
  Strip strip;
  for (std::uint32_t i = 0; i < strip.collapse.size(); ++i)
    if (i % 5 > 0) strip.collapse[i] = 1.0;
  const MergedVertices merged = strip.at(2.0);
  for (std::uint32_t i = 0; i < merged.root.size(); ++i) {
    ASSERT_NE(merged.root[i], MergedVertices::kGone);
    EXPECT_LE(merged.root[i] % 5, 1U);
  }
}

TEST(VertexMerging, NothingIsLeftWhereNothingLives) {
  Strip strip;
  strip.collapse.assign(strip.collapse.size(), 1.0);
  for (const std::uint32_t root : strip.at(2.0).root) EXPECT_EQ(root, MergedVertices::kGone);
}

}  // namespace
}  // namespace lamina
