// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

// Eigen's decompositions of small dense systems, compiled once, here, as the compilation takes many seconds.

namespace lamina {

/// The minimum-norm least-squares solution x of matrix x = right.
/// @param dependent  pivots smaller than this, relative to the greatest one, count as 0
Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                 double dependent);

/// Singular values of a matrix, the greatest first.
Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix);

/// Singular value decomposition of a matrix: left · diagonal(values) · rightᵀ, with the greatest value first.
struct SingularParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
  Eigen::MatrixXd right;
};
/// The thin singular value decomposition: `left` and `right` have as many columns as the smaller side of the
/// matrix.
SingularParts singularParts(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a symmetric matrix, ascending, and the eigenvectors as columns.
struct SymmetricParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// The eigenvalues and eigenvectors of a matrix of which only the lower triangle is read.
SymmetricParts symmetricParts(const Eigen::MatrixXd& matrix);

/// Solutions of a symmetric, positive semidefinite system, one column for each right side.
Eigen::MatrixXd symmetricSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Matrix for the six degrees of freedom of a body, or for six joints.
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;
/// Solution of a system whose matrix must be regular; otherwise the result is not finite.
Vector6d solutionOf(const Matrix6d& matrix, const Vector6d& right);
Matrix6d solutionOf(const Matrix6d& matrix, const Matrix6d& right);
/// The same for the seven joints of a redundant arm.
using Matrix7d = Eigen::Matrix<double, 7, 7>;
using Vector7d = Eigen::Matrix<double, 7, 1>;
Vector7d solutionOf(const Matrix7d& matrix, const Vector7d& right);
Matrix6d inverseOf(const Matrix6d& matrix);

}  // namespace lamina
