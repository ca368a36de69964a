// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_neighbours.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

std::vector<std::uint32_t> listed(const VertexNeighbours& neighbours, std::uint32_t vertex) {
  const auto range = neighbours.of(vertex);
  return {range.begin(), range.end()};
}

TEST(VertexNeighbours, AreThoseOnCommonEdgesInAscendingOrder) {
  Mesh mesh;
  mesh.vertices.resize(5, Point3::Zero());
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const VertexNeighbours neighbours(mesh);
  EXPECT_EQ(listed(neighbours, 0), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(listed(neighbours, 1), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(listed(neighbours, 2), (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_TRUE(listed(neighbours, 4).empty());
}

TEST(VertexNeighbours, OfAMeshWithoutTrianglesAreNone) {
  Mesh mesh;
  mesh.vertices.resize(1, Point3::Zero());
  EXPECT_TRUE(listed(VertexNeighbours(mesh), 0).empty());
}

}  // namespace
}  // namespace lamina
