// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina::test {

/// The mesh with its inside and outside swapped.
inline Mesh turnedInsideOut(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Equal vertices made one, as a reader of STL files does.
inline Mesh welded(const Mesh& mesh) {
  Mesh result;
  std::vector<std::uint32_t> index;
  for (const Point3& vertex : mesh.vertices) {
    const auto found = std::find(result.vertices.begin(), result.vertices.end(), vertex);
    index.push_back(static_cast<std::uint32_t>(found - result.vertices.begin()));
    if (found == result.vertices.end()) result.vertices.push_back(vertex);
  }
  for (const Triangle& t : mesh.triangles)
    result.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  return result;
}

/// Axis-aligned box of 12 triangles.
inline Mesh boxBetween(const Point3& low, const Point3& high) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.emplace_back((corner & 1) != 0 ? high.x() : low.x(), (corner & 2) != 0 ? high.y() : low.y(),
                               (corner & 4) != 0 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Corner at the origin, edges of length 1 along the axes.
inline Mesh cornerTetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Two points at z = -1 and 1 above a square of half-diagonal 1 at z = 0.
inline Mesh octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

/// Rings of vertices between two poles; `radius(theta, phi)` [mm] from the origin, theta from +z.
template <class Radius>
Mesh starShaped(std::uint32_t rings, std::uint32_t around, Radius radius) {
  Mesh mesh;
  const auto put = [&](double theta, double phi) {
    const double r = radius(theta, phi);
    mesh.vertices.emplace_back(r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                               r * std::cos(theta));
  };
  put(0.0, 0.0);
  for (std::uint32_t i = 1; i < rings; ++i)
    for (std::uint32_t j = 0; j < around; ++j) put(M_PI * i / rings, 2.0 * M_PI * j / around);
  put(M_PI, 0.0);
  const auto at = [around](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * around + j % around; };
  const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({south, at(rings - 1, j + 1), at(rings - 1, j)});
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace lamina::test
