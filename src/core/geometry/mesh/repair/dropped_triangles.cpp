// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/mesh/repair/steps.hpp"

namespace lamina {
namespace {

bool namesAVertexTwice(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// The corners from the smallest on, in the same turning sense.
Triangle fromSmallestCorner(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

struct Numbered {
  Triangle corners;
  std::uint32_t triangle;
};

/// Keeps the triangles whose number is not in the sorted list.
void eraseTriangles(Mesh& mesh, const std::vector<std::uint32_t>& dropped) {
  auto next = dropped.begin();
  std::size_t kept = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (next != dropped.end() && *next == t) {
      ++next;
    } else {
      mesh.triangles[kept++] = mesh.triangles[t];
    }
  }
  mesh.triangles.resize(kept);
}

RepairStep drop(Mesh mesh, std::vector<std::uint32_t> dropped, const char* what) {
  if (dropped.empty()) return {std::move(mesh), {}};
  std::sort(dropped.begin(), dropped.end());
  const RepairChange change = {what, dropped.size(), middleOf(mesh, mesh.triangles[dropped.front()])};
  eraseTriangles(mesh, dropped);
  return {std::move(mesh), {change}};
}

/// Of these triangles, all but the first of each run of the same corners after sorting.
template <class Normalise>
std::vector<std::uint32_t> findRepeated(const Mesh& mesh, const std::vector<std::uint32_t>& triangles,
                                        Normalise normalise) {
  std::vector<Numbered> sorted;
  sorted.reserve(triangles.size());
  for (const std::uint32_t t : triangles) sorted.push_back({normalise(mesh.triangles[t]), t});
  std::sort(sorted.begin(), sorted.end(), [](const Numbered& a, const Numbered& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.triangle < b.triangle;
  });
  std::vector<std::uint32_t> repeated;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].corners == sorted[i - 1].corners) repeated.push_back(sorted[i].triangle);
  return repeated;
}

/// The triangles between border vertices only. A repeated triangle is one of them: its edges have too many
/// half-edges.
std::vector<std::uint32_t> trianglesBetweenBorders(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<bool> is_border(mesh.vertices.size(), false);
  for (HalfEdge h = 0; h < topology.opposite.size(); ++h) {
    if (topology.opposite[h] != kNoHalfEdge) continue;
    is_border[originOf(mesh, h)] = true;
    is_border[originOf(mesh, nextInTriangle(h))] = true;
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    if (is_border[triangle[0]] && is_border[triangle[1]] && is_border[triangle[2]]) found.push_back(t);
  }
  return found;
}

/// Whether the triangles enclose nothing in all, as the two sides of a doubled surface do.
bool enclosesNothing(const Mesh& mesh) {
  return std::abs(volume(mesh)) <= 1e-12 * surfaceArea(mesh) * boundingBox(mesh).size().norm();
}

}  // namespace

Point3 middleOf(const Mesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

RepairStep dropDegenerateTriangles(Mesh mesh) {
  std::vector<std::uint32_t> degenerate;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (namesAVertexTwice(mesh.triangles[t])) degenerate.push_back(t);
  return drop(std::move(mesh), std::move(degenerate), "degenerate triangles dropped");
}

RepairStep dropRepeatedTriangles(Mesh mesh, const MeshTopology& topology) {
  std::vector<std::uint32_t> repeated =
      findRepeated(mesh, trianglesBetweenBorders(mesh, topology), fromSmallestCorner);
  return drop(std::move(mesh), std::move(repeated), "repeated triangles dropped");
}

RepairStep dropBackOfDoubledSurface(Mesh mesh) {
  if (!enclosesNothing(mesh)) return {std::move(mesh), {}};
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::uint32_t> doubled = findRepeated(mesh, all, [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  });
  if (2 * doubled.size() != mesh.triangles.size()) return {std::move(mesh), {}};
  return drop(std::move(mesh), std::move(doubled), "triangles of the back of a doubled surface dropped");
}

}  // namespace lamina
