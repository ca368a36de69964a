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

/// Of what a file may become.
inline constexpr std::size_t kMostTriangles = 200'000'000;

/// Triangles as an indexed format stores them: positions may repeat or go unused, indices are not yet
/// checked.
struct IndexedFaces {
  std::vector<std::array<double, 3>> positions;
  std::vector<Triangle> triangles;
};

/// Adds a polygon as a fan about its first corner.
void addFan(IndexedFaces& faces, const std::vector<std::uint32_t>& polygon);

/// Gives equal positions one index and leaves out those that no triangle uses.
/// @throws InvalidMesh if a triangle names a position that is not there
Mesh weld(const IndexedFaces& faces, const std::string& name);

}  // namespace lamina
