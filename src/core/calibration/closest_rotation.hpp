// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace lamina {

/// A rotation and the trace that it attains.
struct ClosestRotation {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double trace = 0.0;  ///< trace of the rotation's transpose times the matrix
};

/// The rotation whose transpose times a matrix has the greatest trace. For a sum of products of points and
/// their targets, it brings the points nearest to the targets [Kabsch1976]. It is never a reflection, even if
/// the matrix is one, or has rank 2.
ClosestRotation closestRotation(const Eigen::Matrix3d& matrix);

}  // namespace lamina
