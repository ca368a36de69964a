// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Open surfaces made of a grid of triangles.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina::test {

/// Counter-clockwise seen from the side of (along u) x (along v), diagonals alternating. `place` gives the
/// point of u and v, both from 0 to 1.
template <class Place>
Mesh patch(std::uint32_t columns, std::uint32_t rows, const Place& place) {
  Mesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.vertices.push_back(place(double(i) / columns, double(j) / rows));
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i;
      const std::uint32_t d = a + columns + 1;
      const bool is_odd = (i + j) % 2 == 1;
      mesh.triangles.push_back(is_odd ? Triangle{a, a + 1, d + 1} : Triangle{a, a + 1, d});
      mesh.triangles.push_back(is_odd ? Triangle{a, d + 1, d} : Triangle{a + 1, d + 1, d});
    }
  return mesh;
}

/// The same closed around: u = 1 is u = 0.
template <class Place>
Mesh band(std::uint32_t columns, std::uint32_t rows, const Place& place) {
  Mesh mesh = patch(columns, rows, place);
  std::vector<Point3> vertices;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    if (i % (columns + 1) != columns) vertices.push_back(mesh.vertices[i]);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& vertex : triangle)
      vertex = vertex / (columns + 1) * columns + vertex % (columns + 1) % columns;
  mesh.vertices = std::move(vertices);
  return mesh;
}

/// A disc around a vertex, counter-clockwise seen from +z: `place` gives the point of the share of the
/// radius, 0 to 1, and the angle.
template <class Place>
Mesh disc(std::uint32_t around, std::uint32_t rings, const Place& place) {
  Mesh mesh;
  mesh.vertices.push_back(place(0.0, 0.0));
  for (std::uint32_t i = 1; i <= rings; ++i)
    for (std::uint32_t j = 0; j < around; ++j)
      mesh.vertices.push_back(place(double(i) / rings, 2.0 * M_PI * j / around));
  const auto at = [around](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * around + j % around; };
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (std::uint32_t i = 1; i < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Level, from 0 to `width` and `depth` mm.
inline Mesh plateMesh(std::uint32_t columns, std::uint32_t rows, double width, double depth) {
  return patch(columns, rows, [=](double u, double v) { return Point3(width * u, depth * v, 0.0); });
}

/// Half of a lying cylinder along y, seen from above.
inline Mesh halfCylinderMesh(std::uint32_t columns, std::uint32_t rows, double radius, double length) {
  return patch(columns, rows, [=](double u, double v) {
    return Point3(-radius * std::cos(M_PI * u), length * v, radius * std::sin(M_PI * u));
  });
}

/// A cone that opens downwards at 45 degrees, its apex at the origin; `radius` along the slope.
inline Mesh coneMesh(std::uint32_t around, std::uint32_t rings, double radius) {
  return disc(around, rings, [=](double share, double angle) {
    const double r = share * radius * std::sqrt(0.5);
    return Point3(r * std::cos(angle), r * std::sin(angle), -r);
  });
}

/// A cap of a sphere around the origin, `opening` rad from the z axis to its rim.
inline Mesh capMesh(std::uint32_t around, std::uint32_t rings, double radius, double opening) {
  return disc(around, rings, [=](double share, double angle) {
    const double theta = share * opening;
    return Point3(radius * std::sin(theta) * std::cos(angle), radius * std::sin(theta) * std::sin(angle),
                  radius * std::cos(theta));
  });
}

/// A layer of 0.2 mm, the nozzle above it.
inline LayerSurface layerOf(Mesh middle) {
  LayerSurface layer;
  layer.tip.reserve(middle.vertices.size());
  for (const Point3& vertex : middle.vertices) layer.tip.emplace_back(vertex + Point3(0.0, 0.0, 0.1));
  layer.normal.assign(middle.vertices.size(), Point3::UnitZ());
  layer.height_mm.assign(middle.vertices.size(), 0.2);
  layer.middle = std::move(middle);
  return layer;
}

}  // namespace lamina::test
