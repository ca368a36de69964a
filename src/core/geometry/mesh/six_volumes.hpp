// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Six times the signed volume between a triangle and a point [mm³]; positive if the point is on the inside.
inline double sixVolumes(const Mesh& mesh, const Triangle& t, const Point3& from) {
  return (mesh.vertices[t[0]] - from).dot((mesh.vertices[t[1]] - from).cross(mesh.vertices[t[2]] - from));
}

/// Signed volume between all triangles and a point [mm³]: the volume that a closed mesh encloses, wherever
/// the point is.
inline double volumeFrom(const Point3& point, const Mesh& mesh) {
  double six_volumes = 0.0;
  for (const Triangle& t : mesh.triangles) six_volumes += sixVolumes(mesh, t, point);
  return six_volumes / 6.0;
}

}  // namespace lamina
