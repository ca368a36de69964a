// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina::test {

/// The square-section solid with a regular octagon as profile, 10 mm high, standing on z = 0
/// [Guacheta2021, table 5-3]: slopes of 45 degrees between squares of 4.1421 and 10 mm.
inline Mesh octagonSolid() {
  const double rise = 10.0 / (2.0 + std::sqrt(2.0));
  const std::array<std::array<double, 2>, 4> rings = {
      {{5.0 - rise, 0.0}, {5.0, rise}, {5.0, 10.0 - rise}, {5.0 - rise, 10.0}}};
  Mesh mesh;
  for (const auto& [half, z] : rings) {
    mesh.vertices.emplace_back(-half, -half, z);
    mesh.vertices.emplace_back(half, -half, z);
    mesh.vertices.emplace_back(half, half, z);
    mesh.vertices.emplace_back(-half, half, z);
  }
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  add(3, 2, 1, 0);
  add(12, 13, 14, 15);
  for (std::uint32_t ring = 0; ring < 12; ring += 4)
    for (std::uint32_t i = 0; i < 4; ++i)
      add(ring + i, ring + (i + 1) % 4, ring + 4 + (i + 1) % 4, ring + 4 + i);
  return mesh;
}

/// A surface over a grid of n x n cells: place(u, v) with u and v from 0 to 1. Triangles face along the cross
/// product of its derivatives.
inline Mesh gridSurface(int n, const std::function<Point3(double, double)>& place) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.vertices.push_back(place(double(i) / n, double(j) / n));
  const auto row = static_cast<std::uint32_t>(n + 1);
  for (std::uint32_t j = 0; j + 1 < row; ++j)
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t corner = row * j + i;
      mesh.triangles.push_back({corner, corner + 1, corner + row + 1});
      mesh.triangles.push_back({corner, corner + row + 1, corner + row});
    }
  return mesh;
}

/// What an outline of (radius, height) in mm sweeps around the z axis, standing on its first point; its first
/// and last point are on the axis, all others are not.
inline Mesh revolved(const std::vector<Point2>& outline, std::uint32_t segments = 64) {
  Mesh mesh;
  const auto rings = static_cast<std::uint32_t>(outline.size() - 2);
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2.0 * M_PI * i / segments;
      const Point2& at = outline[ring + 1];
      mesh.vertices.emplace_back(at.x() * std::cos(angle), at.x() * std::sin(angle), at.y());
    }
  const std::uint32_t low = rings * segments;
  mesh.vertices.emplace_back(0.0, 0.0, outline.front().y());
  mesh.vertices.emplace_back(0.0, 0.0, outline.back().y());
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = (i + 1) % segments;
    mesh.triangles.push_back({low, next, i});
    mesh.triangles.push_back({low + 1, low - segments + i, low - segments + next});
    for (std::uint32_t from = 0; from + segments < low; from += segments) {
      mesh.triangles.push_back({from + i, from + next, from + segments + next});
      mesh.triangles.push_back({from + i, from + segments + next, from + segments + i});
    }
  }
  return mesh;
}

/// Half a ball of 10 mm on its flat side.
inline Mesh dome() {
  std::vector<Point2> outline = {{0.0, 0.0}};
  for (int i = 0; i < 24; ++i)
    outline.emplace_back(10.0 * std::cos(i * M_PI / 48.0), 10.0 * std::sin(i * M_PI / 48.0));
  outline.emplace_back(0.0, 10.0);
  return revolved(outline);
}

/// A plate 20 x 10 mm bent over an axis along y at z = 0, from radius 20 to 22 mm, with upright ends.
inline Mesh bentPlate() {
  constexpr int kCells = 40;
  Mesh mesh;
  for (const double y : {0.0, 10.0})
    for (const double radius : {20.0, 22.0})
      for (int i = 0; i <= kCells; ++i) {
        const double x = -10.0 + 20.0 * i / kCells;
        mesh.vertices.emplace_back(x, y, std::sqrt(radius * radius - x * x));
      }
  constexpr std::uint32_t kRow = kCells + 1;
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < kCells; ++i) {
    add(i, 2 * kRow + i, 2 * kRow + i + 1, i + 1);                        // below
    add(kRow + i, kRow + i + 1, 3 * kRow + i + 1, 3 * kRow + i);          // above
    add(i, i + 1, kRow + i + 1, kRow + i);                                // y = 0
    add(2 * kRow + i + 1, 2 * kRow + i, 3 * kRow + i, 3 * kRow + i + 1);  // y = 10
  }
  add(0, kRow, 3 * kRow, 2 * kRow);
  add(kCells, 2 * kRow + kCells, 3 * kRow + kCells, kRow + kCells);
  return mesh;
}

}  // namespace lamina::test
