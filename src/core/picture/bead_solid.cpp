// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/bead_solid.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace lamina {

Mesh beadSolid(const BeadOfMotion& motion) {
  const Point3 across = (motion.to - motion.from).cross(motion.tool_axis);
  if (!(across.norm() > 0.0)) return {};
  const Point3 side = 0.5 * motion.bead.width_mm * across.normalized();
  const Point3 low = motion.bead.height_mm * motion.tool_axis;
  Mesh mesh;
  mesh.vertices.reserve(8);
  for (const Point3& end : {motion.from, motion.to})
    mesh.vertices.insert(mesh.vertices.end(), {end - side, end + side, end + side + low, end - side + low});
  mesh.triangles.reserve(12);
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    mesh.triangles.push_back({k, 4 + next, next});
    mesh.triangles.push_back({k, 4 + k, 4 + next});
  }
  for (const Triangle& corner : std::array<Triangle, 4>{Triangle{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}})
    mesh.triangles.push_back(corner);
  return mesh;
}

}  // namespace lamina
