// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A closed line of corners that a hole's new triangles shall span.
struct Hole {
  std::vector<std::uint32_t> corners;  ///< each once, counter-clockwise seen from outside the solid
  std::vector<Point3>
      normals;  ///< of the triangle across the edge from corner i to i + 1; 0 if it has no area
};

/// Triangles between the corners, two fewer than there are: always so that each edge of the line gets exactly
/// one. Small holes get the triangulation whose sharpest fold is least and then whose area is ([Liepa2003],
/// cubic in the corners); large ones are clipped ear by ear in their mean plane.
std::vector<Triangle> triangulate(const Hole& hole, const std::vector<Point3>& vertices);

}  // namespace lamina
