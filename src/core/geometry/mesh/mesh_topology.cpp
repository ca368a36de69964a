// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh_topology.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace lamina {
namespace {

/// A triangle at the edge, seen along the edge. A triangle that follows the edge's direction has material on
/// its clockwise side, one that runs against it on its counter-clockwise side.
struct Side {
  double angle_rad;
  bool closes_material;  // going round counter-clockwise: the triangle follows the edge's direction
  HalfEdge half_edge;
};

/// Sides in counter-clockwise order; of two that lie on each other, the one that closes a wedge comes first.
std::vector<Side> sidesAround(const Mesh& mesh, const std::vector<HalfEdge>& half_edges) {
  const HalfEdge reference = half_edges.front();
  const std::uint32_t origin_vertex = originOf(mesh, reference);
  const Point3& origin = mesh.vertices[origin_vertex];
  const Point3 axis = (mesh.vertices[originOf(mesh, nextInTriangle(reference))] - origin).normalized();
  const Point3 x = axis.unitOrthogonal();
  const Point3 y = axis.cross(x);
  std::vector<Side> sides;
  for (const HalfEdge half_edge : half_edges) {
    const Point3 apex = mesh.vertices[originOf(mesh, previousInTriangle(half_edge))] - origin;
    sides.push_back(
        {std::atan2(apex.dot(y), apex.dot(x)), originOf(mesh, half_edge) == origin_vertex, half_edge});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.angle_rad, !a.closes_material, a.half_edge) <
           std::tuple(b.angle_rad, !b.closes_material, b.half_edge);
  });
  return sides;
}

/// Pairs the half-edges of one edge by the angle of their triangles around it, each pair one of either
/// direction and the two sides of one wedge of material; wedges nest but never cross. Where triangles lie on
/// each other, the bodies on their two sides stay apart. Triangles without area have no angle and are paired
/// in any of these ways. What has no partner is left out.
///
/// @param half_edges  all of one edge between two different vertices
std::vector<std::pair<HalfEdge, HalfEdge>> pairWedges(const Mesh& mesh,
                                                      const std::vector<HalfEdge>& half_edges) {
  // Matching brackets on a circle: sides that open wait on the stack for the next one that closes; the second
  // round closes the wedges that reach across the angle where counting began.
  std::vector<std::pair<HalfEdge, HalfEdge>> pairs;
  std::vector<HalfEdge> waiting;
  std::vector<Side> sides = sidesAround(mesh, half_edges);
  for (int round = 0; round < 2; ++round) {
    std::vector<Side> unmatched;
    for (const Side& side : sides) {
      if (!side.closes_material) {
        if (round == 0) waiting.push_back(side.half_edge);
      } else if (waiting.empty()) {
        unmatched.push_back(side);
      } else {
        pairs.emplace_back(waiting.back(), side.half_edge);
        waiting.pop_back();
      }
    }
    sides = std::move(unmatched);
  }
  return pairs;
}

/// A half-edge in the bucket of its lower vertex.
struct Spoke {
  std::uint32_t higher_vertex;
  HalfEdge half_edge;
};

/// All half-edges, grouped by the lower of their two vertices.
struct Fans {
  std::vector<std::uint32_t> begin;  // of vertex v's spokes; one more than there are vertices
  std::vector<Spoke> spokes;
};

template <class Visit>
void forEachHalfEdge(const Mesh& mesh, Visit visit) {
  HalfEdge half_edge = 0;
  for (const Triangle& t : mesh.triangles) {
    visit(t[0], t[1], half_edge);
    visit(t[1], t[2], half_edge + 1);
    visit(t[2], t[0], half_edge + 2);
    half_edge += 3;
  }
}

/// Counting sort: linear, and neighbours in the file stay neighbours in memory.
Fans fansOf(const Mesh& mesh) {
  Fans fans;
  fans.begin.assign(mesh.vertices.size() + 2, 0);
  // Counted two places ahead, so that filling leaves each fan's begin where it belongs.
  forEachHalfEdge(mesh,
                  [&](std::uint32_t a, std::uint32_t b, HalfEdge) { ++fans.begin[std::min(a, b) + 2]; });
  for (std::size_t v = 2; v < fans.begin.size(); ++v) fans.begin[v] += fans.begin[v - 1];
  fans.spokes.resize(3 * mesh.triangles.size());
  forEachHalfEdge(mesh, [&](std::uint32_t a, std::uint32_t b, HalfEdge half_edge) {
    fans.spokes[fans.begin[std::min(a, b) + 1]++] = {std::max(a, b), half_edge};
  });
  fans.begin.pop_back();
  return fans;
}

void sortByHigherVertex(Spoke* first, Spoke* last) {
  constexpr std::ptrdiff_t kSmall = 24;
  const auto precedes = [](const Spoke& a, const Spoke& b) {
    return a.higher_vertex != b.higher_vertex ? a.higher_vertex < b.higher_vertex : a.half_edge < b.half_edge;
  };
  if (last - first > kSmall) return std::sort(first, last, precedes);
  for (Spoke* i = first; i != last; ++i) {
    const Spoke moved = *i;
    Spoke* hole = i;
    for (; hole != first && precedes(moved, hole[-1]); --hole) *hole = hole[-1];
    *hole = moved;
  }
}

class Pairing {
 public:
  explicit Pairing(const Mesh& mesh) : mesh_(mesh) {
    topology_.opposite.assign(3 * mesh.triangles.size(), kNoHalfEdge);
  }

  /// @param first, last  half-edges of one edge
  void pairEdge(std::uint32_t lower_vertex, const Spoke* first, const Spoke* last) {
    if (first->higher_vertex == lower_vertex) return;
    if (last - first == 2 && isForward(lower_vertex, first[0]) != isForward(lower_vertex, first[1])) {
      join(first[0].half_edge, first[1].half_edge);
    } else if (last - first <= 2) {
      topology_.has_border = true;
    } else {
      pairMany(first, last);
    }
  }

  MeshTopology result() && { return std::move(topology_); }

 private:
  bool isForward(std::uint32_t lower_vertex, const Spoke& spoke) const {
    return originOf(mesh_, spoke.half_edge) == lower_vertex;
  }

  void join(HalfEdge a, HalfEdge b) {
    topology_.opposite[a] = b;
    topology_.opposite[b] = a;
  }

  void pairMany(const Spoke* first, const Spoke* last) {
    std::vector<HalfEdge> around;
    for (const Spoke* spoke = first; spoke != last; ++spoke) around.push_back(spoke->half_edge);
    const auto pairs = pairWedges(mesh_, around);
    for (const auto& [a, b] : pairs) join(a, b);
    if (2 * pairs.size() != around.size()) topology_.has_border = true;
  }

  const Mesh& mesh_;
  MeshTopology topology_;
};

}  // namespace

MeshTopology pairHalfEdges(const Mesh& mesh) {
  Fans fans = fansOf(mesh);
  Pairing pairing(mesh);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    Spoke* const end = fans.spokes.data() + fans.begin[v + 1];
    Spoke* edge = fans.spokes.data() + fans.begin[v];
    sortByHigherVertex(edge, end);
    while (edge != end) {
      Spoke* edge_end = edge + 1;
      while (edge_end != end && edge_end->higher_vertex == edge->higher_vertex) ++edge_end;
      pairing.pairEdge(v, edge, edge_end);
      edge = edge_end;
    }
  }
  return std::move(pairing).result();
}

}  // namespace lamina
