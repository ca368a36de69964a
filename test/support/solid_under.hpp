// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina::test {

/// The solid on z = 0 over a rectangle from the origin, up to `height(x, y)` at the corners of
/// columns x rows cells, whose two triangles meet along the rising diagonal.
template <class Height>
Mesh solidUnder(const Point2& size, std::uint32_t columns, std::uint32_t rows, Height height) {
  Mesh mesh;
  const std::uint32_t width = columns + 1;
  const std::uint32_t layer = width * (rows + 1);
  for (const bool is_top : {false, true})
    for (std::uint32_t j = 0; j <= rows; ++j)
      for (std::uint32_t i = 0; i <= columns; ++i) {
        const double x = size.x() * i / columns;
        const double y = size.y() * j / rows;
        mesh.vertices.emplace_back(x, y, is_top ? height(x, y) : 0.0);
      }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t c = j * width + i;
      mesh.triangles.push_back({c, c + width + 1, c + 1});
      mesh.triangles.push_back({c, c + width, c + width + 1});
      mesh.triangles.push_back({layer + c, layer + c + 1, layer + c + width + 1});
      mesh.triangles.push_back({layer + c, layer + c + width + 1, layer + c + width});
    }
  const auto wall = [&](std::uint32_t a, std::uint32_t b) {
    mesh.triangles.push_back({a, b, layer + b});
    mesh.triangles.push_back({a, layer + b, layer + a});
  };
  for (std::uint32_t i = 0; i < columns; ++i) {
    wall(i, i + 1);
    wall(rows * width + i + 1, rows * width + i);
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    wall(j * width + columns, (j + 1) * width + columns);
    wall((j + 1) * width, j * width);
  }
  return mesh;
}

}  // namespace lamina::test
