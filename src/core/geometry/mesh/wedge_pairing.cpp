// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh/wedge_pairing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

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

}  // namespace

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

}  // namespace lamina
