// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/mesh/repair/steps.hpp"

namespace lamina {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct Placed {
  Cell cell;
  std::uint32_t vertex;

  bool operator<(const Placed& other) const {
    return cell != other.cell ? cell < other.cell : vertex < other.vertex;
  }
};

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

/// Border vertices in cells as large as the tolerance, so that near ones lie in neighbouring cells.
class NearVertices {
 public:
  NearVertices(const Mesh& mesh, const std::vector<std::uint32_t>& vertices, double tolerance)
      : mesh_(mesh), tolerance_(tolerance) {
    for (const std::uint32_t v : vertices) placed_.push_back({cellOf(mesh.vertices[v]), v});
    std::sort(placed_.begin(), placed_.end());
  }

  /// The first vertex within the tolerance of v that comes before it and stands for itself, or v.
  std::uint32_t representativeOf(std::uint32_t v, const std::vector<std::uint32_t>& representatives) const {
    std::uint32_t found = v;
    const Cell middle = cellOf(mesh_.vertices[v]);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y) {
        // Cells along z are neighbours in the sorted list.
        const Cell first = {middle[0] + x, middle[1] + y, middle[2] - 1};
        const Cell last = {first[0], first[1], middle[2] + 1};
        auto near = std::lower_bound(placed_.begin(), placed_.end(), Placed{first, 0});
        for (; near != placed_.end() && near->cell <= last; ++near) {
          const bool is_earlier = near->vertex < found && representatives[near->vertex] == near->vertex;
          if (is_earlier && isNear(near->vertex, v)) found = near->vertex;
        }
      }
    return found;
  }

 private:
  bool isNear(std::uint32_t a, std::uint32_t b) const {
    return (mesh_.vertices[a] - mesh_.vertices[b]).norm() <= tolerance_;
  }

  Cell cellOf(const Point3& point) const {
    const auto number = [this](double x) { return static_cast<std::int64_t>(std::floor(x / tolerance_)); };
    return {number(point.x()), number(point.y()), number(point.z())};
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<Placed> placed_;
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
