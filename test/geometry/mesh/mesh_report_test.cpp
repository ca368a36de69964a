// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh_report.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

MeshReport report(const Mesh& mesh) {
  NoProgress progress;
  return reportMesh(mesh, progress);
}

Mesh box() { return makePart("box", {{"x_mm", "2"}, {"y_mm", "3"}, {"z_mm", "4"}}); }

TEST(MeshReport, ReportsABoxAsItIs) {
  const MeshReport r = report(box());
  EXPECT_EQ(r.triangles, 12u);
  EXPECT_EQ(r.vertices, 8u);
  EXPECT_EQ(r.box.size(), Point3(2, 3, 4));
  EXPECT_DOUBLE_EQ(r.volume_mm3, 24.0);
  EXPECT_DOUBLE_EQ(r.area_mm2, 52.0);
  EXPECT_TRUE(r.is_closed);
  EXPECT_EQ(r.bodies, 1u);
  EXPECT_EQ(r.border_edges + r.border_loops + r.nonmanifold_edges + r.inconsistent_edges, 0u);
  EXPECT_EQ(r.degenerate_triangles + r.flat_triangles + r.self_intersections.pairs, 0u);
  EXPECT_STREQ(toString(r.orientation), "outward");
}

TEST(MeshReport, CountsTheBorderOfAMissingTriangle) {
  Mesh mesh = box();
  mesh.triangles.pop_back();
  const MeshReport r = report(mesh);
  EXPECT_FALSE(r.is_closed);
  EXPECT_EQ(r.border_edges, 3u);
  EXPECT_EQ(r.border_loops, 1u);
}

TEST(MeshReport, CountsTheEdgesOfATurnedTriangle) {
  Mesh mesh = box();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshReport r = report(mesh);
  EXPECT_FALSE(r.is_closed);
  EXPECT_EQ(r.inconsistent_edges, 3u);
  EXPECT_EQ(r.border_edges, 0u);
  EXPECT_EQ(r.border_loops, 0u);
  EXPECT_EQ(r.bodies, 1u);
  EXPECT_EQ(r.orientation, MeshOrientation::Inconsistent);
}

TEST(MeshReport, ReportsAMeshThatIsInsideOut) {
  Mesh mesh = box();
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(report(mesh).orientation, MeshOrientation::Inward);
  EXPECT_DOUBLE_EQ(report(mesh).volume_mm3, -24.0);
}

TEST(MeshReport, ReportsBodiesThatFaceDifferentWays) {
  Mesh mesh = box();
  for (const Triangle& t : box().triangles) mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  for (const Point3& vertex : box().vertices) mesh.vertices.push_back(0.5 * vertex + Point3(9, 0, 0));
  const MeshReport r = report(mesh);
  EXPECT_EQ(r.bodies, 2u);
  EXPECT_EQ(r.orientation, MeshOrientation::Mixed);
}

TEST(MeshReport, CountsEdgesOfFourTrianglesAsClosed) {
  // Two tetrahedra with a common edge.
  const Mesh mesh = {
      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {2, 3, 1}, {0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {4, 5, 1}}};
  const MeshReport r = report(mesh);
  EXPECT_TRUE(r.is_closed);
  EXPECT_EQ(r.nonmanifold_edges, 1u);
  EXPECT_EQ(r.bodies, 2u);
}

TEST(MeshReport, DistinguishesDegenerateAndFlatTriangles) {
  Mesh mesh = box();
  mesh.triangles.push_back({0, 0, 1});
  mesh.vertices.push_back(0.5 * (mesh.vertices[0] + mesh.vertices[1]));
  mesh.triangles.push_back({0, 8, 1});
  const MeshReport r = report(mesh);
  EXPECT_EQ(r.degenerate_triangles, 1u);
  EXPECT_EQ(r.flat_triangles, 1u);
}

TEST(MeshReport, OfNothingIsNothing) {
  const MeshReport r = report({});
  EXPECT_FALSE(r.is_closed);
  EXPECT_EQ(r.bodies, 0u);
}

}  // namespace
}  // namespace lamina
