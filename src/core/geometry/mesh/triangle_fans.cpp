// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/triangle_fans.hpp"

#include <Eigen/Geometry>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

FanCorner cornerAt(const Mesh& mesh, const Triangle& triangle, std::size_t i) {
  FanCorner corner;
  corner.next = triangle[(i + 1) % 3];
  corner.previous = triangle[(i + 2) % 3];
  const Point3 to_next = mesh.vertices[corner.next] - mesh.vertices[triangle[i]];
  const Point3 to_previous = mesh.vertices[corner.previous] - mesh.vertices[triangle[i]];
  corner.to_next = to_next.norm();
  corner.to_previous = to_previous.norm();
  corner.dot = to_next.dot(to_previous);
  corner.cross = to_next.cross(to_previous).norm();
  return corner;
}

}  // namespace

TriangleFans gatherFans(const Mesh& mesh) {
  TriangleFans fans;
  fans.first.assign(mesh.vertices.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= mesh.vertices.size())
        throw InvalidMesh("a triangle names vertex " + std::to_string(vertex) + "; the mesh has " +
                          std::to_string(mesh.vertices.size()));
      ++fans.first[vertex + 1];
    }
  for (std::size_t i = 1; i < fans.first.size(); ++i) fans.first[i] += fans.first[i - 1];
  fans.corners.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> free(fans.first.begin(), fans.first.end() - 1);
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) fans.corners[free[triangle[i]]++] = cornerAt(mesh, triangle, i);
  return fans;
}

}  // namespace lamina
