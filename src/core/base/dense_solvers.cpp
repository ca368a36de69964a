// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/dense_solvers.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace lamina {

Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                 double dependent) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(dependent);
  solver.compute(matrix);
  return solver.solve(right);
}

Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

SingularParts singularParts(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {parts.singularValues(), parts.matrixU(), parts.matrixV()};
}

SymmetricParts symmetricParts(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(matrix);
  return {parts.eigenvalues(), parts.eigenvectors()};
}

Eigen::MatrixXd symmetricSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.ldlt().solve(right);
}

Vector6d solutionOf(const Matrix6d& matrix, const Vector6d& right) {
  return matrix.partialPivLu().solve(right);
}

Matrix6d solutionOf(const Matrix6d& matrix, const Matrix6d& right) {
  return matrix.partialPivLu().solve(right);
}

Vector7d solutionOf(const Matrix7d& matrix, const Vector7d& right) {
  return matrix.partialPivLu().solve(right);
}

Matrix6d inverseOf(const Matrix6d& matrix) { return matrix.inverse(); }

}  // namespace lamina
