// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A triangle as seen from one of its corners, by lengths alone.
struct FanCorner {
  std::uint32_t next = 0;      ///< vertex after the corner in counter-clockwise order
  std::uint32_t previous = 0;  ///< vertex before the corner
  double to_next = 0.0;        ///< [mm]
  double to_previous = 0.0;    ///< [mm]
  double dot = 0.0;            ///< scalar product of the vectors to both vertices [mm²]
  double cross = 0.0;          ///< length of their vector product: twice the area [mm²]
};

/// The triangles around each vertex of a mesh, in one array.
struct TriangleFans {
  std::vector<std::uint32_t> first;  ///< index in `corners` where each vertex begins, and the end of the last
  std::vector<FanCorner> corners;    ///< those of each vertex, in the order of the triangles

  std::size_t vertices() const { return first.size() - 1; }
};

/// The fans of all vertices of a mesh.
/// @throws InvalidMesh if a triangle names a vertex that the mesh does not have
TriangleFans gatherFans(const Mesh& mesh);

}  // namespace lamina
