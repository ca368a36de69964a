// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/layer_plane.hpp"

#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {}  // namespace

Eigen::Quaterniond partFromLayers(const PlaneSettings& plane) {
  if (plane.angle_deg == 0.0) return Eigen::Quaterniond::Identity();
  const double heading = plane.axis_heading_deg * kDegree;
  const Point3 axis(std::cos(heading), std::sin(heading), 0.0);
  return Eigen::Quaterniond(Eigen::AngleAxisd(plane.angle_deg * kDegree, axis));
}

Mesh turned(Mesh mesh, const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  for (Point3& vertex : mesh.vertices) vertex = matrix * vertex;
  return mesh;
}

}  // namespace lamina
