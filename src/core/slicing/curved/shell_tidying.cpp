// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/shell_tidying.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/surface_cut.hpp"

namespace lamina {
namespace {

// More corners than a hole smaller than a bead has.
constexpr std::size_t kMostCorners = 64;

using Loop = std::vector<std::uint32_t>;

/// The side after the given one around where a piece ends.
HalfEdge nextOnBorder(const MeshTopology& topology, HalfEdge side) {
  side = nextInTriangle(side);
  while (topology.opposite[side] != kNoHalfEdge) side = nextInTriangle(topology.opposite[side]);
  return side;
}

/// The loops around which a piece ends, its triangles to the left.
std::vector<Loop> borders(const Mesh& mesh) {
  const MeshTopology topology = pairHalfEdges(mesh);
  const auto count = static_cast<HalfEdge>(topology.opposite.size());
  std::vector<char> is_walked(count, 0);
  std::vector<Loop> loops;
  for (HalfEdge start = 0; start < count; ++start) {
    if (topology.opposite[start] != kNoHalfEdge || is_walked[start] != 0) continue;
    loops.emplace_back();
    for (HalfEdge side = start; is_walked[side] == 0; side = nextOnBorder(topology, side)) {
      is_walked[side] = 1;
      loops.back().push_back(originOf(mesh, side));
    }
  }
  return loops;
}

/// Twice the loop's area, along the normal of what fills it.
Point3 doubledArea(const Mesh& mesh, const Loop& loop) {
  const Point3& origin = mesh.vertices[loop.front()];
  Point3 sum = Point3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += (mesh.vertices[loop[i + 1]] - origin).cross(mesh.vertices[loop[i]] - origin);
  return sum;
}

void close(LayerSurface& piece, const Loop& loop) {
  const double share = 1.0 / static_cast<double>(loop.size());
  Point3 middle = Point3::Zero();
  Point3 tip = Point3::Zero();
  Point3 normal = Point3::Zero();
  double height = 0.0;
  for (const std::uint32_t vertex : loop) {
    middle += share * piece.middle.vertices[vertex];
    tip += share * piece.tip[vertex];
    normal += piece.normal[vertex];
    height += share * piece.height_mm[vertex];
  }
  const auto facesForward = [&](std::size_t i) {
    const Point3& a = piece.middle.vertices[loop[i]];
    const Point3& b = piece.middle.vertices[loop[(i + 1) % loop.size()]];
    return (a - b).cross(middle - b).dot(normal) > 0.0;
  };
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!facesForward(i)) return;
  const auto centre = static_cast<std::uint32_t>(piece.tip.size());
  piece.middle.vertices.push_back(middle);
  piece.tip.push_back(tip);
  piece.normal.emplace_back(normal.normalized());
  piece.height_mm.push_back(height);
  for (std::size_t i = 0; i < loop.size(); ++i)
    piece.middle.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], centre});
}

void append(LayerSurface& whole, const LayerSurface& piece) {
  const auto first = static_cast<std::uint32_t>(whole.tip.size());
  for (const Triangle& corner : piece.middle.triangles)
    whole.middle.triangles.push_back({corner[0] + first, corner[1] + first, corner[2] + first});
  for (std::size_t i = 0; i < piece.tip.size(); ++i) {
    whole.middle.vertices.push_back(piece.middle.vertices[i]);
    whole.tip.push_back(piece.tip[i]);
    whole.normal.push_back(piece.normal[i]);
    whole.height_mm.push_back(piece.height_mm[i]);
  }
}

}  // namespace

LayerSurface tidied(const LayerSurface& shell, const TidyLimits& limits) {
  LayerSurface whole;
  for (LayerSurface& piece : connectedPieces(shell)) {
    if (surfaceArea(piece.middle) < limits.least_piece_mm2) continue;
    const std::vector<Loop> loops = borders(piece.middle);
    for (const Loop& loop : loops) {
      if (loop.size() > kMostCorners || loops.size() == 1) continue;
      const Point3 doubled = doubledArea(piece.middle, loop);
      const bool is_hole = doubled.dot(piece.normal[loop.front()]) > 0.0;
      if (is_hole && doubled.norm() < 2.0 * limits.largest_hole_mm2) close(piece, loop);
    }
    append(whole, piece);
  }
  return whole;
}

}  // namespace lamina
