// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

// Eigen's decompositions of small dense systems, each compiled once: it takes many seconds.

namespace lamina {

/// The shortest of the x for which |matrix x - right| is least.
/// @param dependent  pivots smaller than that, over the greatest, count as 0
Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                 double dependent);

/// Singular values, the greatest first.
Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix);

/// A matrix by its singular value decomposition: left · diagonal(values) · rightᵀ, the greatest value first.
struct SingularParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
  Eigen::MatrixXd right;
};
/// Thin: as many columns as the smaller side.
SingularParts singularParts(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a symmetric matrix, ascending, and their vectors as columns.
struct SymmetricParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// Only the lower triangle is read.
SymmetricParts symmetricParts(const Eigen::MatrixXd& matrix);

/// Solution of a symmetric, semidefinite system, a column for each right side.
Eigen::MatrixXd symmetricSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Systems of the six directions of a body, or of six joints.
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;
/// The matrix has an inverse: else the result is not finite.
Vector6d solutionOf(const Matrix6d& matrix, const Vector6d& right);
Matrix6d solutionOf(const Matrix6d& matrix, const Matrix6d& right);
Matrix6d inverseOf(const Matrix6d& matrix);

}  // namespace lamina
