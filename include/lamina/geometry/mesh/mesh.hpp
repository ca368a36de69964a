// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Indices of a triangle's vertices, counter-clockwise seen from outside the solid.
using Triangle = std::array<std::uint32_t, 3>;

/// Indexed triangles: vertices [mm, part frame], each stored once. Neither closedness nor orientation is
/// guaranteed; `reportMesh` finds defects, `repairMesh` repairs them.
struct Mesh {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
};

/// The smallest box around the vertices that triangles use; empty for a mesh without triangles.
Box3 boundingBox(const Mesh& mesh);

/// Enclosed volume [mm³] by the divergence theorem; positive if the triangles face outwards. Meaningful for
/// closed meshes; parts that overlap count twice.
double volume(const Mesh& mesh);

/// Sum of the triangles' areas [mm²].
double surfaceArea(const Mesh& mesh);

/// Both meshes as one; equal vertices are not merged.
Mesh joined(Mesh mesh, const Mesh& further);

}  // namespace lamina
