// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina::test {

/// A closed solid about the z axis through one ring of vertices per height: `radius(phi, z)` [mm]. Rings lie
/// vertex above vertex, bottom and top are fans.
template <class Radius>
Mesh loftedSolid(const std::vector<double>& heights, std::uint32_t around, Radius radius) {
  Mesh mesh;
  for (const double z : heights) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double phi = 2.0 * M_PI * j / around;
      const double r = radius(phi, z);
      mesh.vertices.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
  }
  const auto rings = static_cast<std::uint32_t>(heights.size());
  const auto at = [around](std::uint32_t ring, std::uint32_t j) { return ring * around + j % around; };
  const std::uint32_t below = rings * around;
  mesh.vertices.emplace_back(0.0, 0.0, heights.front());
  mesh.vertices.emplace_back(0.0, 0.0, heights.back());
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({below, at(0, j + 1), at(0, j)});
    mesh.triangles.push_back({below + 1, at(rings - 1, j), at(rings - 1, j + 1)});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, j), at(ring, j + 1), at(ring + 1, j + 1)});
      mesh.triangles.push_back({at(ring, j), at(ring + 1, j + 1), at(ring + 1, j)});
    }
  }
  return mesh;
}

}  // namespace lamina::test
