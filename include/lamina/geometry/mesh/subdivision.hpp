// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A mesh in which some edges were halved, once or several times.
struct Subdivision {
  Mesh mesh;  ///< the original vertices under their numbers, followed by the new ones
  /// For each new vertex in order: the two vertices, both of lower numbers, midway between which the new one
  /// lies.
  std::vector<std::array<std::uint32_t, 2>> ends;
};

/// Divides a mesh until no edge is longer than `longest_edge_mm`: longer edges are halved, in all triangles
/// that share them, so that closed meshes stay closed.
///
/// @throws InvalidInput if the length is not positive, or more than 20 million triangles would result
Subdivision subdivide(const Mesh& mesh, double longest_edge_mm);

}  // namespace lamina
