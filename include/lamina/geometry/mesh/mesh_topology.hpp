// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Half-edge 3 t + k runs along triangle t from its corner k to its corner (k + 1) % 3.
using HalfEdge = std::uint32_t;

/// Stands for the missing half-edge across a border.
constexpr HalfEdge kNoHalfEdge = 0xFFFFFFFFU;

inline std::uint32_t triangleOf(HalfEdge half_edge) { return half_edge / 3; }
inline HalfEdge nextInTriangle(HalfEdge half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline HalfEdge previousInTriangle(HalfEdge half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}
inline std::uint32_t originOf(const Mesh& mesh, HalfEdge half_edge) {
  return mesh.triangles[half_edge / 3][half_edge % 3];
}

/// For each half-edge of a mesh, the half-edge on the other side of its edge.
struct MeshTopology {
  /// One for each half-edge: the half-edge of the same edge in the opposite direction, or `kNoHalfEdge`.
  /// Opposites are mutual.
  std::vector<HalfEdge> opposite;
  /// Whether any half-edge between two different vertices has no opposite.
  bool has_border = false;
};

/// Pairs the half-edges of each edge that run in opposite directions. Where more than two triangles meet,
/// half-edges are paired by the angle of their triangles around the edge, such that each pair bounds one
/// wedge of material: surfaces touch along the edge without crossing. Half-edges without a partner stay
/// single: those on borders, those between neighbours of inconsistent orientation, and those of length zero
/// in triangles that have the same vertex twice. Time is linear in the number of triangles.
MeshTopology pairHalfEdges(const Mesh& mesh);

}  // namespace lamina
