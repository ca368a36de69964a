// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/isosurface.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// An edge of the unit cube: from a corner one step along an axis.
struct CubeEdge {
  std::array<int, 3> corner{};
  int axis = 0;
};

/// The twelve edges: four along x, four along y, four along z.
const std::array<CubeEdge, 12>& cubeEdges();

/// A closed line over edges of the cube that parts the corners inside from those outside, counter-clockwise
/// seen from outside.
struct CubeLoop {
  std::vector<std::uint8_t> edges;
  /// A fan from the first edge has no diagonal within a face of the cube. If false, only a fan about a point
  /// amid the loop has none.
  bool is_fan = true;
};

/// The loops of a cube. Bit x + 2 y + 4 z of the case is set if that corner is inside.
const std::vector<CubeLoop>& cubeLoops(unsigned corners_inside);

constexpr std::uint8_t kNoEdge = 12;
using Corner = std::array<int, 3>;

bool isInside(unsigned corners_inside, const Corner& corner) {
  return (corners_inside >> (corner[0] + 2 * corner[1] + 4 * corner[2]) & 1U) != 0;
}

std::uint8_t edgeBetween(const Corner& a, const Corner& b) {
  const auto& edges = cubeEdges();
  for (std::uint8_t e = 0; e < kNoEdge; ++e) {
    Corner end = edges[e].corner;
    end[static_cast<std::size_t>(edges[e].axis)] = 1;
    if ((edges[e].corner == a && end == b) || (edges[e].corner == b && end == a)) return e;
  }
  return kNoEdge;
}

/// The corners of a face, counter-clockwise seen from outside the cube.
std::array<Corner, 4> faceCorners(std::size_t axis, int side) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  std::array<Corner, 4> corners{};
  const std::array<std::array<int, 2>, 4> ring{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& at = ring[side == 1 ? i : 3 - i];
    corners[i][axis] = side;
    corners[i][u] = at[0];
    corners[i][v] = at[1];
  }
  return corners;
}

/// From each crossed edge to the next one around what is inside. Around the corners of a face, a line starts
/// where the ring goes out of what is inside and ends where it last came in: crosswise corners stay apart.
std::array<std::uint8_t, 12> successors(unsigned corners_inside) {
  std::array<std::uint8_t, 12> next{};
  next.fill(kNoEdge);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      const std::array<Corner, 4> ring = faceCorners(axis, side);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!isInside(corners_inside, ring[i]) || isInside(corners_inside, ring[(i + 1) % 4])) continue;
        std::size_t first = i;
        while (isInside(corners_inside, ring[(first + 3) % 4])) first = (first + 3) % 4;
        next[edgeBetween(ring[(first + 3) % 4], ring[first])] = edgeBetween(ring[i], ring[(i + 1) % 4]);
      }
    }
  return next;
}

bool shareFace(const CubeEdge& a, const CubeEdge& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool is_in_faces =
        static_cast<std::size_t>(a.axis) != axis && static_cast<std::size_t>(b.axis) != axis;
    if (is_in_faces && a.corner[axis] == b.corner[axis]) return true;
  }
  return false;
}

bool isFan(const std::vector<std::uint8_t>& loop) {
  for (std::size_t i = 2; i + 1 < loop.size(); ++i)
    if (shareFace(cubeEdges()[loop[0]], cubeEdges()[loop[i]])) return false;
  return true;
}

CubeLoop turnedToFan(std::vector<std::uint8_t> loop) {
  for (std::size_t turn = 0; turn < loop.size(); ++turn) {
    if (isFan(loop)) return {std::move(loop), true};
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
  return {std::move(loop), false};
}

std::vector<CubeLoop> loopsOf(unsigned corners_inside) {
  std::array<std::uint8_t, 12> next = successors(corners_inside);
  std::vector<CubeLoop> loops;
  for (std::uint8_t start = 0; start < 12; ++start) {
    std::vector<std::uint8_t> loop;
    for (std::uint8_t edge = start; next[edge] != kNoEdge;) {
      loop.push_back(edge);
      const std::uint8_t after = next[edge];
      next[edge] = kNoEdge;
      edge = after;
    }
    if (!loop.empty()) loops.push_back(turnedToFan(std::move(loop)));
  }
  return loops;
}

std::array<CubeEdge, 12> listedEdges() {
  std::array<CubeEdge, 12> edges;
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int v : {0, 1})
      for (const int u : {0, 1}) {
        CubeEdge& edge = edges[count++];
        edge.axis = axis;
        edge.corner[static_cast<std::size_t>((axis + 1) % 3)] = u;
        edge.corner[static_cast<std::size_t>((axis + 2) % 3)] = v;
      }
  return edges;
}

const std::array<CubeEdge, 12>& cubeEdges() {
  static const std::array<CubeEdge, 12> edges = listedEdges();
  return edges;
}

const std::vector<CubeLoop>& cubeLoops(unsigned corners_inside) {
  static const std::array<std::vector<CubeLoop>, 256> cases = [] {
    std::array<std::vector<CubeLoop>, 256> made;
    for (unsigned corners = 0; corners < 256; ++corners) made[corners] = loopsOf(corners);
    return made;
  }();
  return cases[corners_inside];
}

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Vertices on the edges that start at the lattice points of a slice, by axis. The slice reaches one point
/// beyond the frame on the low sides.
class SliceVertices {
 public:
  SliceVertices(int columns, int rows)
      : columns_(static_cast<std::size_t>(columns) + 2), rows_(static_cast<std::size_t>(rows) + 2) {
    for (auto& along : vertices_) along.assign(columns_ * rows_, kNone);
  }
  void clear() {
    for (auto& along : vertices_) std::fill(along.begin(), along.end(), kNone);
  }
  std::uint32_t& at(int axis, int i, int j) {
    return vertices_[static_cast<std::size_t>(axis)]
                    [static_cast<std::size_t>(j + 1) * columns_ + static_cast<std::size_t>(i + 1)];
  }

 private:
  std::size_t columns_, rows_;
  std::array<std::vector<std::uint32_t>, 3> vertices_;
};

/// Cube (i, j, k) has the lattice points i to i + 1, and so on, as its corners; from -1 on.
class Marching {
 public:
  Marching(const VoxelGrid& inside, const DepthInside& depth)
      : inside_(inside),
        depth_(depth),
        below_(inside.frame().count[0], inside.frame().count[1]),
        above_(inside.frame().count[0], inside.frame().count[1]) {}

  Mesh run() {
    for (int k = -1; k < inside_.frame().count[2]; ++k) {
      for (int j = -1; j < inside_.frame().count[1]; ++j) marchRow(j, k);
      std::swap(below_, above_);
      above_.clear();
    }
    return std::move(mesh_);
  }

 private:
  std::uint64_t word(int w, int j, int k) const {
    const VoxelFrame& frame = inside_.frame();
    const bool is_in =
        w >= 0 && j >= 0 && k >= 0 && w < inside_.wordCount() && j < frame.count[1] && k < frame.count[2];
    return is_in ? inside_.word(w, j, k) : 0;
  }

  void marchRow(int j, int k) {
    for (int w = 0; w < inside_.wordCount(); ++w) {
      std::uint64_t any = 0;
      std::uint64_t all = ~std::uint64_t{0};
      for (const int dk : {0, 1})
        for (const int dj : {0, 1}) {
          const std::uint64_t here = word(w, j + dj, k + dk);
          const std::uint64_t before = here << 1 | word(w - 1, j + dj, k + dk) >> (VoxelGrid::kWord - 1);
          any |= here | before;
          all &= here & before;
        }
      for (std::uint64_t mixed = any & ~all; mixed != 0; mixed &= mixed - 1)
        march(w * VoxelGrid::kWord + __builtin_ctzll(mixed) - 1, j, k);
      // The cube after the last voxel of the row.
      if (w + 1 == inside_.wordCount() && inside_.frame().count[0] % VoxelGrid::kWord == 0)
        march(inside_.frame().count[0] - 1, j, k);
    }
  }

  void march(int i, int j, int k) {
    unsigned corners = 0;
    for (int corner = 0; corner < 8; ++corner)
      if (inside_.isSolid(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)))
        corners |= 1U << corner;
    for (const CubeLoop& loop : cubeLoops(corners)) {
      std::array<std::uint32_t, 12> vertices{};
      for (std::size_t n = 0; n < loop.edges.size(); ++n)
        vertices[n] = vertexOn(cubeEdges()[loop.edges[n]], i, j, k);
      close(loop, vertices);
    }
  }

  void close(const CubeLoop& loop, const std::array<std::uint32_t, 12>& vertices) {
    const std::size_t count = loop.edges.size();
    if (loop.is_fan) {
      for (std::size_t n = 2; n < count; ++n)
        mesh_.triangles.push_back({vertices[0], vertices[n - 1], vertices[n]});
      return;
    }
    Point3 middle = Point3::Zero();
    for (std::size_t n = 0; n < count; ++n)
      middle += mesh_.vertices[vertices[n]] / static_cast<double>(count);
    const std::uint32_t apex = add(middle);
    for (std::size_t n = 0; n < count; ++n)
      mesh_.triangles.push_back({apex, vertices[n], vertices[(n + 1) % count]});
  }

  std::uint32_t vertexOn(const CubeEdge& edge, int i, int j, int k) {
    const std::array<int, 3> from{i + edge.corner[0], j + edge.corner[1], k + edge.corner[2]};
    std::uint32_t& vertex = (edge.corner[2] == 0 ? below_ : above_).at(edge.axis, from[0], from[1]);
    if (vertex == kNone) vertex = add(crossing(from, edge.axis));
    return vertex;
  }

  Point3 crossing(const std::array<int, 3>& from, int axis) const {
    std::array<int, 3> to = from;
    ++to[static_cast<std::size_t>(axis)];
    double along = 0.5;
    if (depth_) {
      const double at_from = depth_(from[0], from[1], from[2]);
      const double at_to = depth_(to[0], to[1], to[2]);
      along = at_from / (at_from - at_to);
    }
    return inside_.frame().centre(from[0], from[1], from[2]) +
           inside_.frame().voxel_mm * along * Point3::Unit(axis);
  }

  std::uint32_t add(const Point3& vertex) {
    if (mesh_.vertices.size() >= kNone)
      throw InvalidMesh("surface has more than " + std::to_string(kNone) + " vertices; take larger voxels");
    mesh_.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  const VoxelGrid& inside_;
  const DepthInside& depth_;
  SliceVertices below_, above_;
  Mesh mesh_;
};

}  // namespace

Mesh isosurface(const VoxelGrid& inside, const DepthInside& depth) { return Marching(inside, depth).run(); }

}  // namespace lamina
