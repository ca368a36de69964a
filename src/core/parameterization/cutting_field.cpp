// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/cutting_field.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/mesh/border_loops.hpp"
#include "geometry/space_vectors.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/geodesic.hpp"

namespace lamina {
namespace {

using Loop = std::vector<HalfEdge>;

// The second longest border makes a piece one that is run around from this share of the longest on.
constexpr double kLongBorder = 0.2;
// Angles around a vertex that miss or exceed a full turn by this much lie flat in no parameterization [rad].
constexpr double kSharp = 0.3;
// The line is not shifted farther than this share of the way to either end.
constexpr double kFarthestShift = 0.5;
// Vertices nearer to the line than this share of their shortest edge come to lie on it.
constexpr double kNear = 0.2;

std::uint32_t farthest(const std::vector<double>& distance) {
  return static_cast<std::uint32_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

std::vector<GeodesicSource> sourcesAt(const std::vector<std::uint32_t>& vertices) {
  std::vector<GeodesicSource> sources;
  sources.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices) sources.push_back({vertex, 0.0});
  return sources;
}

double length(const Mesh& mesh, const Loop& loop) {
  double sum = 0.0;
  for (const HalfEdge side : loop)
    sum += (mesh.vertices[originOf(mesh, nextInTriangle(side))] - mesh.vertices[originOf(mesh, side)]).norm();
  return sum;
}

std::vector<std::uint32_t> verticesOf(const Mesh& mesh, const Loop& loop) {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(loop.size());
  for (const HalfEdge side : loop) vertices.push_back(originOf(mesh, side));
  return vertices;
}

/// Borders from the longest to the shortest; earlier ones first among equals.
std::vector<Loop> bordersByLength(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::pair<double, Loop>> borders;
  for (Loop& loop : findBorderLoops(topology)) borders.emplace_back(-length(mesh, loop), std::move(loop));
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Loop> sorted;
  sorted.reserve(borders.size());
  for (auto& border : borders) sorted.push_back(std::move(border.second));
  return sorted;
}

std::vector<double> fieldBetweenEnds(const GeodesicDistances& geodesics) {
  const std::vector<double> from_one_end = geodesics.from(farthest(geodesics.from(0)));
  return difference(from_one_end, geodesics.from(farthest(from_one_end)));
}

/// Negative near a shortest way between two borders, positive on the other side.
std::vector<double> fieldAlongWays(const Mesh& mesh, const GeodesicDistances& geodesics, const Loop& one,
                                   const Loop& other) {
  const std::vector<double> to_one = geodesics.from(sourcesAt(verticesOf(mesh, one)));
  const std::vector<double> to_other = geodesics.from(sourcesAt(verticesOf(mesh, other)));
  std::uint32_t nearest = originOf(mesh, other.front());
  for (const std::uint32_t vertex : verticesOf(mesh, other))
    if (to_one[vertex] < to_one[nearest]) nearest = vertex;
  const std::vector<double> from_way = geodesics.from(sourcesAt(geodesics.descend(to_one, nearest)));
  const std::uint32_t opposite = farthest(from_way);
  std::vector<std::uint32_t> opposite_way = geodesics.descend(to_one, opposite);
  const std::vector<std::uint32_t> rest = geodesics.descend(to_other, opposite);
  opposite_way.insert(opposite_way.end(), rest.begin() + 1, rest.end());
  return difference(from_way, geodesics.from(sourcesAt(opposite_way)));
}

/// What the angles around each vertex miss of a full turn, negative if they exceed it [rad]. At borders only
/// what exceeds nine tenths of a turn counts.
std::vector<double> missingAngles(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<double> missing(mesh.vertices.size(), 2.0 * M_PI);
  for (const Triangle& corner : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 ab = mesh.vertices[corner[(i + 1) % 3]] - mesh.vertices[corner[i]];
      const Point3 ac = mesh.vertices[corner[(i + 2) % 3]] - mesh.vertices[corner[i]];
      missing[corner[i]] -= angleBetween(ab, ac);
    }
  std::vector<bool> is_border(missing.size(), false);
  for (HalfEdge side = 0; side < topology.opposite.size(); ++side)
    if (topology.opposite[side] == kNoHalfEdge)
      is_border[originOf(mesh, side)] = is_border[originOf(mesh, nextInTriangle(side))] = true;
  for (std::size_t i = 0; i < missing.size(); ++i)
    if (is_border[i]) missing[i] = std::min(0.0, missing[i] - 0.2 * M_PI);
  return missing;
}

/// Lets the line run through the sharpest vertex that is not too far from it.
void shiftToSharpest(const std::vector<double>& missing, std::vector<double>& field) {
  const auto [lowest, highest] = std::minmax_element(field.begin(), field.end());
  const double low = kFarthestShift * *lowest;
  const double high = kFarthestShift * *highest;
  std::size_t sharpest = field.size();
  double greatest = kSharp;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] < low || field[i] > high || std::abs(missing[i]) <= greatest) continue;
    greatest = std::abs(missing[i]);
    sharpest = i;
  }
  if (sharpest == field.size()) return;
  const double shift = field[sharpest];
  for (double& value : field) value -= shift;
}

/// Leaves no slivers along the line, and no triangle that lies on it with all its corners.
void keepClearOfVertices(const Mesh& mesh, std::vector<double>& field) {
  std::vector<double> reach(field.size(), std::numeric_limits<double>::infinity());
  for (const Triangle& corner : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corner[i];
      const std::uint32_t b = corner[(i + 1) % 3];
      const double near = kNear * (mesh.vertices[a] - mesh.vertices[b]).norm();
      reach[a] = std::min(reach[a], near);
      reach[b] = std::min(reach[b], near);
    }
  const std::vector<double> before = field;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (std::abs(field[i]) < reach[i]) field[i] = 0.0;
  for (const Triangle& corner : mesh.triangles) {
    if (field[corner[0]] != 0.0 || field[corner[1]] != 0.0 || field[corner[2]] != 0.0) continue;
    const std::uint32_t off = *std::max_element(
        corner.begin(), corner.end(),
        [&](std::uint32_t a, std::uint32_t b) { return std::abs(before[a]) < std::abs(before[b]); });
    field[off] = before[off] != 0.0 ? before[off] : reach[off];
  }
}

}  // namespace

std::vector<double> cuttingField(const Mesh& piece) {
  const MeshTopology topology = pairHalfEdges(piece);
  const GeodesicDistances geodesics(piece);
  const std::vector<Loop> borders = bordersByLength(piece, topology);
  const bool is_run_around =
      borders.size() > 1 && length(piece, borders[1]) >= kLongBorder * length(piece, borders[0]);
  std::vector<double> field =
      is_run_around ? fieldAlongWays(piece, geodesics, borders[0], borders[1]) : fieldBetweenEnds(geodesics);
  shiftToSharpest(missingAngles(piece, topology), field);
  keepClearOfVertices(piece, field);
  return field;
}

}  // namespace lamina
