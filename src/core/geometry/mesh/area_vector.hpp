// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Normal of a triangle of the mesh, with twice the triangle's area as its length.
inline Point3 areaVector(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  return (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
}

/// Normal of a triangle by its number, of unit length; 0 for one without area.
inline Point3 triangleNormal(const Mesh& mesh, std::size_t number) {
  return areaVector(mesh, mesh.triangles[number]).stableNormalized();
}

/// Area of a triangle by its number [mm²].
inline double triangleArea(const Mesh& mesh, std::size_t number) {
  return 0.5 * areaVector(mesh, mesh.triangles[number]).norm();
}

}  // namespace lamina
