// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "geometry/mesh/repair/steps.hpp"
#include "geometry/spatial/box_tree.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-9;  // of the tolerance

std::vector<std::uint32_t> borderVertices(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::uint32_t> vertices;
  for (HalfEdge h = 0; h < topology.opposite.size(); ++h) {
    if (topology.opposite[h] != kNoHalfEdge) continue;
    vertices.push_back(originOf(mesh, h));
    vertices.push_back(originOf(mesh, nextInTriangle(h)));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Finds border vertices near each other.
class NearVertices {
 public:
  NearVertices(const Mesh& mesh, const std::vector<std::uint32_t>& vertices, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), vertices_(vertices), places_(boxesOf(mesh, vertices)) {}

  /// The first vertex within the tolerance of v that comes before it and stands for itself, or v.
  std::uint32_t representativeOf(std::uint32_t v, const std::vector<std::uint32_t>& representatives) const {
    std::uint32_t found = v;
    const Point3& at = mesh_.vertices[v];
    const Point3 reach = Point3::Constant((1.0 + kRounding) * tolerance_);
    places_.visitOverlapping({at - reach, at + reach}, [&](std::uint32_t i) {
      const std::uint32_t near = vertices_[i];
      if (near < found && representatives[near] == near && (mesh_.vertices[near] - at).norm() <= tolerance_)
        found = near;
    });
    return found;
  }

 private:
  static std::vector<Box3> boxesOf(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
    std::vector<Box3> boxes;
    boxes.reserve(vertices.size());
    for (const std::uint32_t v : vertices) boxes.push_back({mesh.vertices[v], mesh.vertices[v]});
    return boxes;
  }

  const Mesh& mesh_;
  double tolerance_;
  const std::vector<std::uint32_t>& vertices_;
  BoxTree places_;
};

}  // namespace

RepairStep stitchBorders(Mesh mesh, const MeshTopology& topology, double tolerance) {
  const std::vector<std::uint32_t> border = borderVertices(mesh, topology);
  std::vector<std::uint32_t> representatives(mesh.vertices.size());
  std::iota(representatives.begin(), representatives.end(), 0U);
  const NearVertices near(mesh, border, tolerance);
  RepairChange change = {"border vertices stitched to others", 0, {}};
  for (const std::uint32_t v : border) {
    representatives[v] = near.representativeOf(v, representatives);
    if (representatives[v] != v && change.count++ == 0) change.where = mesh.vertices[v];
  }
  if (change.count == 0) return {std::move(mesh), {}};
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = representatives[v];
  return {std::move(mesh), {change}};
}

}  // namespace lamina
