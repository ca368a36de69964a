// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/voxel/cube_cases.hpp"

#include <algorithm>

namespace lamina {
namespace {

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

}  // namespace

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

}  // namespace lamina
