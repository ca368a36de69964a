// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace lamina {

/// A rotation and how far it is stretched.
struct ClosestRotation {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double trace = 0.0;  ///< of its transpose times the matrix
};

/// The rotation whose transpose times a matrix has the greatest trace: of the products of points and the
/// places they go to, the one that leads the points nearest to these places [Kabsch1976]. It is no reflection
/// even if the matrix is one, or is of rank 2.
ClosestRotation closestRotation(const Eigen::Matrix3d& matrix);

}  // namespace lamina
