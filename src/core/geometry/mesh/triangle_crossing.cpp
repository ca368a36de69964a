// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh/triangle_crossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

/// On which side of the plane through a, b, c the point d lies: 1 below (a, b, c seen clockwise from d), -1
/// above, 0 if rounding leaves it open. The bound is that of [Shewchuk1997] for this expression.
int sideOf(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double kRelativeError = 7.8e-16;
  const Point3 x = a - d, y = b - d, z = c - d;
  const double yz = y.x() * z.y() - z.x() * y.y();
  const double zx = z.x() * x.y() - x.x() * z.y();
  const double xy = x.x() * y.y() - y.x() * x.y();
  const double determinant = x.z() * yz + y.z() * zx + z.z() * xy;
  const double size = (std::abs(y.x() * z.y()) + std::abs(z.x() * y.y())) * std::abs(x.z()) +
                      (std::abs(z.x() * x.y()) + std::abs(x.x() * z.y())) * std::abs(y.z()) +
                      (std::abs(x.x() * y.y()) + std::abs(y.x() * x.y())) * std::abs(z.z());
  const double error = kRelativeError * size;
  return determinant > error ? 1 : (determinant < -error ? -1 : 0);
}

class Crossing {
 public:
  Crossing(const Mesh& mesh, const MeshTopology& topology, std::uint32_t triangle)
      : mesh_(mesh), topology_(topology), triangle_(triangle) {}

  /// Where the edge passes through the triangle, if it does.
  std::optional<Point3> find(const Point3& from, const Point3& to) const {
    const Point3 &a = corner(0), &b = corner(1), &c = corner(2);
    const int side = sideOf(a, b, c, from);
    if (side == 0 || side != -sideOf(a, b, c, to)) return std::nullopt;
    // The edge passes all three sides of the triangle the same way round, or meets one of them.
    const int ways[3] = {sideOf(from, to, a, b), sideOf(from, to, b, c), sideOf(from, to, c, a)};
    if (ways[0] * ways[1] < 0 || ways[1] * ways[2] < 0 || ways[2] * ways[0] < 0) return std::nullopt;
    const auto zeros = std::count(ways, ways + 3, 0);
    if (zeros > 1) return std::nullopt;
    if (zeros == 1 && !passesBetween(static_cast<HalfEdge>(std::find(ways, ways + 3, 0) - ways), from, to))
      return std::nullopt;
    const Point3 normal = (b - a).cross(c - a);
    const double along = normal.dot(to - from);
    if (along == 0.0) return std::nullopt;
    return Point3(from + (normal.dot(a - from) / along) * (to - from));
  }

 private:
  const Point3& corner(HalfEdge i) const { return mesh_.vertices[mesh_.triangles[triangle_][i]]; }

  static int sideOfTriangle(const Mesh& mesh, const Triangle& t, const Point3& point) {
    return sideOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], point);
  }

  /// Whether an edge that meets side i of the triangle gets from one side of the surface to the other there.
  bool passesBetween(HalfEdge i, const Point3& from, const Point3& to) const {
    const HalfEdge opposite = topology_.opposite[3 * triangle_ + i];
    if (opposite == kNoHalfEdge) return false;
    const Triangle& own = mesh_.triangles[triangle_];
    const Triangle& other = mesh_.triangles[triangleOf(opposite)];
    const int fold =
        sideOfTriangle(mesh_, own, mesh_.vertices[originOf(mesh_, previousInTriangle(opposite))]);
    // Side 1 is below. Folded down, the inside is below both triangles; folded up, the outside is above both.
    const int inner = fold >= 0 ? 1 : -1;
    const auto is_between = [&](const Point3& point) {
      return sideOfTriangle(mesh_, own, point) == inner && sideOfTriangle(mesh_, other, point) == inner;
    };
    const auto is_beyond = [&](const Point3& point) {
      return sideOfTriangle(mesh_, own, point) == -inner || sideOfTriangle(mesh_, other, point) == -inner;
    };
    return (is_between(from) && is_beyond(to)) || (is_between(to) && is_beyond(from));
  }

  const Mesh& mesh_;
  const MeshTopology& topology_;
  std::uint32_t triangle_;
};

/// The corners of a that b has too, as a bit each. Two common ones leave no edge to be compared.
unsigned sharedCorners(const Triangle& a, const Triangle& b) {
  unsigned shared = 0;
  for (unsigned i = 0; i < 3; ++i)
    if (std::find(b.begin(), b.end(), a[i]) != b.end()) shared |= 1U << i;
  return shared;
}

}  // namespace

std::optional<Point3> findCrossing(const Mesh& mesh, const MeshTopology& topology, std::uint32_t a,
                                   std::uint32_t b) {
  for (const auto& [edges, face] : {std::pair(a, b), std::pair(b, a)}) {
    const Triangle& corners = mesh.triangles[edges];
    const unsigned shared = sharedCorners(corners, mesh.triangles[face]);
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned j = (i + 1) % 3;
      // Edges that start at a common corner touch there and nowhere else.
      if ((shared & (1U << i | 1U << j)) != 0) continue;
      const Crossing crossing(mesh, topology, face);
      if (auto point = crossing.find(mesh.vertices[corners[i]], mesh.vertices[corners[j]])) return point;
    }
  }
  return std::nullopt;
}

}  // namespace lamina
