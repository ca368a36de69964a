// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh.hpp"

#include "geometry/mesh/six_volumes.hpp"

namespace lamina {

Box3 boundingBox(const Mesh& mesh) {
  Box3 box;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle) box.include(mesh.vertices[v]);
  return box;
}

double volume(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  // Summed about a vertex of the mesh, so that a part far from the origin loses no digits.
  return volumeFrom(mesh.vertices[mesh.triangles.front()[0]], mesh);
}

double surfaceArea(const Mesh& mesh) {
  double two_areas = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Point3& a = mesh.vertices[t[0]];
    two_areas += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return 0.5 * two_areas;
}

Mesh joined(Mesh mesh, const Mesh& further) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), further.vertices.begin(), further.vertices.end());
  for (const Triangle& corner : further.triangles)
    mesh.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
  return mesh;
}

}  // namespace lamina
