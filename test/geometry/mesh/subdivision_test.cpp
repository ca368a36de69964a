// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/subdivision.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

double longestEdge(const Mesh& mesh) {
  double longest = 0.0;
  for (const Triangle& corner : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (mesh.vertices[corner[k]] - mesh.vertices[corner[(k + 1) % 3]]).norm());
  return longest;
}

TEST(Subdivision, LeavesNoLongEdgeAndTheSameClosedSolid) {
  const Mesh blade = makePart("blade", {{"points", "12"}, {"sections", "3"}});
  EXPECT_TRUE(rc::check([&] {
    const double bound = *rc::gen::inRange(10, 400) / 10.0;
    const Subdivision result = subdivide(blade, bound);
    RC_ASSERT(longestEdge(result.mesh) <= bound);
    RC_ASSERT(!pairHalfEdges(result.mesh).has_border);
    RC_ASSERT(std::abs(volume(result.mesh) / volume(blade) - 1.0) < 1e-9);
    RC_ASSERT(std::abs(surfaceArea(result.mesh) / surfaceArea(blade) - 1.0) < 1e-9);
  }));
}

TEST(Subdivision, NewVerticesAreHalfwayBetweenEarlierOnes) {
  const Mesh box = makePart("box");
  const Subdivision result = subdivide(box, 3.0);
  ASSERT_EQ(result.mesh.vertices.size(), box.vertices.size() + result.ends.size());
  for (std::size_t i = 0; i < result.ends.size(); ++i) {
    const auto [first, second] = result.ends[i];
    const std::size_t vertex = box.vertices.size() + i;
    ASSERT_LT(first, vertex);
    ASSERT_LT(second, vertex);
    EXPECT_EQ(result.mesh.vertices[vertex],
              Point3(0.5 * (result.mesh.vertices[first] + result.mesh.vertices[second])));
  }
}

TEST(Subdivision, AMeshWithoutLongEdgesStaysAsItIs) {
  const Mesh box = makePart("box");
  const Subdivision result = subdivide(box, 100.0);
  EXPECT_EQ(result.mesh.triangles, box.triangles);
  EXPECT_TRUE(result.ends.empty());
}

TEST(Subdivision, ALengthThatIsNotPositiveIsRefused) {
  EXPECT_THROW(subdivide(makePart("box"), 0.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
