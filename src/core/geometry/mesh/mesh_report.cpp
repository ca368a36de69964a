// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh_report.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "geometry/mesh/border_loops.hpp"
#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/repair/steps.hpp"

namespace lamina {
namespace {

/// The half-edges of one edge, by direction.
struct EdgeUse {
  std::size_t forwards = 0;
  std::size_t backwards = 0;
};

template <class Visit>
void forEachEdge(const Mesh& mesh, Visit visit) {
  constexpr std::uint64_t kForwards = 1;
  std::vector<std::uint64_t> keys;
  keys.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      // 31 bits hold a vertex: the readers accept no more.
      const std::uint64_t from = t[i], to = t[(i + 1) % 3];
      if (from != to)
        keys.push_back(std::min(from, to) << 32 | std::max(from, to) << 1 | (from < to ? kForwards : 0));
    }
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size();) {
    EdgeUse use;
    const std::uint64_t edge = keys[i] >> 1;
    for (; i < keys.size() && keys[i] >> 1 == edge; ++i)
      ++((keys[i] & kForwards) != 0 ? use.forwards : use.backwards);
    visit(use);
  }
}

void countEdges(MeshReport& report, const Mesh& mesh) {
  bool has_edges = false;
  forEachEdge(mesh, [&](const EdgeUse& use) {
    has_edges = true;
    const std::size_t faces = use.forwards + use.backwards;
    if (faces > 2) ++report.nonmanifold_edges;
    if (faces % 2 != 0) {
      ++report.border_edges;
    } else if (use.forwards != use.backwards) {
      ++report.inconsistent_edges;
    }
  });
  report.is_closed = report.border_edges + report.inconsistent_edges == 0 && has_edges;
}

std::size_t countFlat(const Mesh& mesh) {
  std::size_t flat = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Point3 v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    // As flat as the rounding of the cross product can make it.
    if (u.cross(v).norm() <= 1e-15 * std::max(u.squaredNorm(), v.squaredNorm())) ++flat;
  }
  return flat;
}

/// Bodies of a mesh whose neighbours agree.
MeshOrientation orientationOf(const Mesh& mesh, const MeshBodies& bodies) {
  const double total = std::accumulate(bodies.volumes.begin(), bodies.volumes.end(), 0.0);
  if (total < 0.0) return MeshOrientation::Inward;
  const std::vector<bool> is_inward = findInwardBodies(mesh, bodies);
  const bool has_inward = std::find(is_inward.begin(), is_inward.end(), true) != is_inward.end();
  return has_inward ? MeshOrientation::Mixed : MeshOrientation::Outward;
}

}  // namespace

const char* toString(MeshOrientation orientation) {
  switch (orientation) {
    case MeshOrientation::Outward:
      return "outward";
    case MeshOrientation::Inward:
      return "inward";
    case MeshOrientation::Mixed:
      return "mixed";
    case MeshOrientation::Inconsistent:
      return "inconsistent";
  }
  return "unknown";
}

MeshReport reportMesh(const Mesh& mesh, Progress& progress) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.vertices.size();
  report.box = boundingBox(mesh);
  report.volume_mm3 = volume(mesh);
  report.area_mm2 = surfaceArea(mesh);
  countEdges(report, mesh);
  const RepairStep clean = dropDegenerateTriangles(mesh);
  report.degenerate_triangles = mesh.triangles.size() - clean.mesh.triangles.size();
  report.flat_triangles = countFlat(clean.mesh);
  // Neighbours that disagree hang together all the same, and have no border between them.
  const RepairStep oriented = orientConsistently(clean.mesh, pairHalfEdges(clean.mesh));
  const MeshTopology topology = pairHalfEdges(oriented.mesh);
  report.border_loops = findBorderLoops(topology).size();
  const MeshBodies bodies = findBodies(oriented.mesh, topology);
  report.bodies = bodies.volumes.size();
  report.orientation =
      report.inconsistent_edges > 0 ? MeshOrientation::Inconsistent : orientationOf(oriented.mesh, bodies);
  report.self_intersections = findSelfIntersections(oriented.mesh, progress);
  return report;
}

}  // namespace lamina
