// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Normal of a triangle of the mesh, with twice the triangle's area as its length.
inline Point3 areaVector(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  return (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
}

}  // namespace lamina
