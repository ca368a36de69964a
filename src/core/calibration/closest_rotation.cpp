// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "closest_rotation.hpp"

#include <Eigen/LU>

#include "base/dense_solvers.hpp"

namespace lamina {

ClosestRotation closestRotation(const Eigen::Matrix3d& matrix) {
  const SingularParts parts = singularParts(matrix);
  const Eigen::Matrix3d left = parts.left;
  const Eigen::Matrix3d right = parts.right;
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  if ((left * right.transpose()).determinant() < 0.0) signs.z() = -1.0;
  return {left * signs.asDiagonal() * right.transpose(), signs.dot(Eigen::Vector3d(parts.values))};
}

}  // namespace lamina
