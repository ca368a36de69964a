// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A surface with some of its edges halved, once or several times.
struct Subdivision {
  Mesh mesh;  ///< the vertices of the surface under their numbers, new ones after them
  /// Of each new vertex, in their order: the vertices it is halfway between, of lower numbers than its own.
  std::vector<std::array<std::uint32_t, 2>> ends;
};

/// The same surface with no edge longer than `longest_edge_mm`: longer edges are halved, those of neighbours
/// at the same places, until none is left. Closed meshes stay closed.
///
/// @throws InvalidInput if the length is not positive, or more than 20 million triangles would result
Subdivision subdivide(const Mesh& mesh, double longest_edge_mm);

}  // namespace lamina
