// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/mesh/border_loops.hpp"
#include "geometry/mesh/repair/hole_triangulation.hpp"
#include "geometry/mesh/repair/steps.hpp"

namespace lamina {
namespace {

/// Cuts a loop at vertices that it passes more than once into loops that pass each vertex once. There and
/// back between two vertices needs no filling and is left out.
std::vector<std::vector<HalfEdge>> simpleLoops(const Mesh& mesh, const std::vector<HalfEdge>& loop) {
  std::vector<std::uint32_t> origins;
  origins.reserve(loop.size());
  for (const HalfEdge h : loop) origins.push_back(originOf(mesh, h));
  std::vector<std::uint32_t> sorted = origins;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  constexpr std::size_t kAbsent = 0xFFFFFFFF;
  std::vector<std::size_t> place(sorted.size(), kAbsent);  // on the path, per vertex
  std::vector<std::vector<HalfEdge>> loops;
  std::vector<HalfEdge> path;
  const auto place_of = [&](std::uint32_t v) -> std::size_t& {
    return place[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) -
                                          sorted.begin())];
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    place_of(origins[i]) = path.size();
    path.push_back(loop[i]);
    const std::size_t start = place_of(origins[(i + 1) % loop.size()]);
    if (start == kAbsent) continue;
    if (path.size() - start > 2)
      loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(start), path.end());
    for (std::size_t k = start; k < path.size(); ++k) place_of(originOf(mesh, path[k])) = kAbsent;
    path.resize(start);
  }
  return loops;
}

/// The hole on the other side of a border: its corners in reverse order.
Hole holeOf(const Mesh& mesh, const std::vector<HalfEdge>& loop) {
  Hole hole;
  for (auto h = loop.rbegin(); h != loop.rend(); ++h) {
    const Triangle& t = mesh.triangles[triangleOf(*h)];
    const Point3& a = mesh.vertices[t[0]];
    hole.corners.push_back(originOf(mesh, nextInTriangle(*h)));
    hole.normals.push_back((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized());
  }
  return hole;
}

Point3 middleOfCorners(const Mesh& mesh, const Hole& hole) {
  Point3 sum = Point3::Zero();
  for (const std::uint32_t corner : hole.corners) sum += mesh.vertices[corner];
  return sum / static_cast<double>(hole.corners.size());
}

}  // namespace

RepairStep fillHoles(Mesh mesh, const MeshTopology& topology) {
  // So many are reported one by one; a mesh full of cracks would fill pages.
  constexpr std::size_t kMostTold = 20;
  std::vector<RepairChange> changes;
  for (const auto& loop : findBorderLoops(topology)) {
    for (const auto& simple : simpleLoops(mesh, loop)) {
      const Hole hole = holeOf(mesh, simple);
      const std::vector<Triangle> filling = triangulate(hole, mesh.vertices);
      mesh.triangles.insert(mesh.triangles.end(), filling.begin(), filling.end());
      if (changes.size() < kMostTold) {
        changes.push_back({"edges around a hole closed", simple.size(), middleOfCorners(mesh, hole)});
      } else {
        if (changes.size() == kMostTold)
          changes.push_back({"further holes closed", 0, middleOfCorners(mesh, hole)});
        ++changes.back().count;
      }
    }
  }
  return {std::move(mesh), std::move(changes)};
}

}  // namespace lamina
