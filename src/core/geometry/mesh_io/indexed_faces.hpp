// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Greatest number of triangles that a file may have.
inline constexpr std::size_t kMostTriangles = 200'000'000;

/// Triangles as an indexed format stores them: positions may be repeated or unused, and indices are not
/// checked yet.
struct IndexedFaces {
  std::vector<std::array<double, 3>> positions;
  std::vector<Triangle> triangles;
};

/// Adds a polygon as a fan of triangles about its first corner.
void addFan(IndexedFaces& faces, const std::vector<std::uint32_t>& polygon);

/// Gives equal positions a common index, and omits unused ones.
/// @throws InvalidMesh if a triangle has an index beyond the positions
Mesh weld(const IndexedFaces& faces, const std::string& name);

}  // namespace lamina
