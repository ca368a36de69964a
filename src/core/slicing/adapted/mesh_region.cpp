// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/mesh_region.hpp"

#include <algorithm>

#include "lamina/geometry/spatial/nearest_triangle.hpp"

namespace lamina {

Mesh facesBetween(const Mesh& mesh, double low, double high) {
  Mesh region;
  region.vertices = mesh.vertices;
  for (const Triangle& corner : mesh.triangles) {
    const auto [least, greatest] = std::minmax(
        {mesh.vertices[corner[0]].z(), mesh.vertices[corner[1]].z(), mesh.vertices[corner[2]].z()});
    if (greatest >= low && least <= high) region.triangles.push_back(corner);
  }
  return region;
}

Mesh facesNear(const Mesh& mesh, const Point3& place, double within_mm) {
  Mesh region;
  region.vertices = mesh.vertices;
  for (const Triangle& corner : mesh.triangles) {
    const Point3 nearest = nearestInTriangle(place, mesh.vertices[corner[0]], mesh.vertices[corner[1]],
                                             mesh.vertices[corner[2]]);
    if ((nearest - place).norm() <= within_mm) region.triangles.push_back(corner);
  }
  return region;
}

}  // namespace lamina
