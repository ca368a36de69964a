// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/self_intersections.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "geometry/mesh/triangle_crossing.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

Mesh selfIntersectionsTogether(Mesh a, const Mesh& b, const Point3& shift) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  for (const Point3& vertex : b.vertices) a.vertices.push_back(vertex + shift);
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

SelfIntersections intersections(const Mesh& mesh) {
  NoProgress progress;
  return findSelfIntersections(mesh, progress);
}

TEST(SelfIntersections, NoPartHasAny) {
  for (const std::string& name : partNames()) EXPECT_EQ(intersections(makePart(name)).pairs, 0u) << name;
}

TEST(SelfIntersections, OfTwoBoxesThatOverlapLieOnBoth) {
  const Mesh box = makePart("box");
  const SelfIntersections found = intersections(selfIntersectionsTogether(box, box, {7, 9, 11}));
  EXPECT_GT(found.pairs, 0u);
  ASSERT_FALSE(found.where.empty());
  for (const Point3& point : found.where) {
    EXPECT_GE(point.x(), -3.0);
    EXPECT_LE(point.x(), 10.0);
    EXPECT_GE(point.z(), 11.0);
    EXPECT_LE(point.z(), 20.0);
  }
}

TEST(SelfIntersections, AreFoundWhereEdgesMeetDiagonals) {
  const Mesh box = makePart("box");
  EXPECT_GT(intersections(selfIntersectionsTogether(box, box, {10, 10, 10})).pairs, 0u);
}

TEST(SelfIntersections, AreNoneBetweenBoxesThatTouch) {
  const Mesh box = makePart("box");
  EXPECT_EQ(intersections(selfIntersectionsTogether(box, box, {20, 0, 0})).pairs, 0u);
  EXPECT_EQ(intersections(selfIntersectionsTogether(box, box, {20, 5, 5})).pairs, 0u);
  EXPECT_EQ(intersections(selfIntersectionsTogether(box, box, {20, 20, 20})).pairs, 0u);
}

TEST(SelfIntersections, OfTrianglesWithACommonVertexAreFound) {
  const Mesh mesh = {{{0, 0, 0}, {4, -1, 0}, {4, 1, 0}, {2, 0, -1}, {2, 0, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(intersections(mesh).pairs, 1u);
  const Mesh apart = {{{0, 0, 0}, {4, -1, 0}, {4, 1, 0}, {-2, 0, -1}, {-2, 0, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(intersections(apart).pairs, 0u);
}

TEST(SelfIntersections, AreTheSameForAnyNumberOfThreads) {
  const Mesh ball = makePart("sphere");
  const Mesh two = selfIntersectionsTogether(ball, ball, {3, 4, 5});
  const SelfIntersections many = intersections(two);
  const ThreadLimit limit(1);
  const SelfIntersections one = intersections(two);
  EXPECT_GT(one.pairs, 100u);
  EXPECT_EQ(one.pairs, many.pairs);
  EXPECT_EQ(one.where, many.where);
}

TEST(SelfIntersections, AgreeWithComparingAllPairs) {
  EXPECT_TRUE(rc::check("the tree misses no pair", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Mesh mesh;
    const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(0, 60));
    for (std::uint32_t i = 0; i < 3 * count; ++i)
      mesh.vertices.emplace_back(random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4));
    for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    const MeshTopology topology = pairHalfEdges(mesh);
    std::size_t pairs = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j)
        if (findCrossing(mesh, topology, i, j)) ++pairs;
    RC_ASSERT(intersections(mesh).pairs == pairs);
  }));
}

}  // namespace
}  // namespace lamina
