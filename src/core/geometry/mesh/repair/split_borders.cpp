// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "geometry/mesh/repair/steps.hpp"
#include "geometry/spatial/box_tree.hpp"

namespace lamina {
namespace {

/// A border vertex on a border edge, at this fraction of it.
struct Junction {
  HalfEdge border;
  double fraction;
  std::uint32_t vertex;

  bool operator<(const Junction& other) const {
    if (border != other.border) return border < other.border;
    return fraction != other.fraction ? fraction < other.fraction : vertex < other.vertex;
  }
};

std::vector<HalfEdge> borderOf(const MeshTopology& topology) {
  std::vector<HalfEdge> border;
  for (HalfEdge h = 0; h < topology.opposite.size(); ++h)
    if (topology.opposite[h] == kNoHalfEdge) border.push_back(h);
  return border;
}

std::vector<Junction> findJunctions(const Mesh& mesh, const MeshTopology& topology, double tolerance) {
  const std::vector<HalfEdge> border = borderOf(topology);
  std::vector<Box3> boxes;
  for (const HalfEdge h : border) {
    Box3& box = boxes.emplace_back();
    box.include(mesh.vertices[originOf(mesh, h)]);
    box.include(mesh.vertices[originOf(mesh, nextInTriangle(h))]);
  }
  const BoxTree tree(std::move(boxes));
  std::vector<Junction> junctions;
  for (const HalfEdge from : border) {
    const std::uint32_t v = originOf(mesh, from);
    const Point3& point = mesh.vertices[v];
    const Point3 reach = Point3::Constant(tolerance);
    tree.visitOverlapping({point - reach, point + reach}, [&](std::uint32_t i) {
      const Triangle& t = mesh.triangles[triangleOf(border[i])];
      if (t[0] == v || t[1] == v || t[2] == v) return;
      const Point3& start = mesh.vertices[originOf(mesh, border[i])];
      const Point3 along = mesh.vertices[originOf(mesh, nextInTriangle(border[i]))] - start;
      const double fraction = (point - start).dot(along) / along.squaredNorm();
      if (fraction > 0.0 && fraction < 1.0 && (start + fraction * along - point).norm() <= tolerance)
        junctions.push_back({border[i], fraction, v});
    });
  }
  std::sort(junctions.begin(), junctions.end());
  return junctions;
}

/// Splits at all junctions of one edge of each triangle; those on its other edges must wait for the next
/// round.
std::size_t splitOneEdgeEach(Mesh& mesh, const std::vector<Junction>& junctions) {
  std::size_t splits = 0;
  for (std::size_t i = 0; i < junctions.size();) {
    const HalfEdge border = junctions[i].border;
    const std::uint32_t triangle = triangleOf(border);
    const std::uint32_t end = originOf(mesh, nextInTriangle(border));
    const std::uint32_t apex = originOf(mesh, previousInTriangle(border));
    std::uint32_t start = originOf(mesh, border);
    for (; i < junctions.size() && junctions[i].border == border; ++i) {
      const std::uint32_t vertex = junctions[i].vertex;
      if (vertex == start) continue;
      mesh.triangles.push_back({start, vertex, apex});
      start = vertex;
      ++splits;
    }
    mesh.triangles[triangle] = {start, end, apex};
    while (i < junctions.size() && triangleOf(junctions[i].border) == triangle) ++i;
  }
  return splits;
}

}  // namespace

RepairStep splitAtBorderVertices(Mesh mesh, const MeshTopology& topology, double tolerance) {
  constexpr int kMostRounds = 8;
  RepairChange change = {"border edges split at vertices on them", 0, {}};
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<Junction> junctions = round == 0 ? findJunctions(mesh, topology, tolerance)
                                                       : findJunctions(mesh, pairHalfEdges(mesh), tolerance);
    if (junctions.empty()) break;
    if (change.count == 0) change.where = mesh.vertices[junctions.front().vertex];
    change.count += splitOneEdgeEach(mesh, junctions);
  }
  if (change.count == 0) return {std::move(mesh), {}};
  return {std::move(mesh), {change}};
}

}  // namespace lamina
