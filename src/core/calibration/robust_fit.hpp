// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace lamina {

/// A problem of weighted least squares: unknowns to be found so that residuals become small.
struct FitProblem {
  /// Residuals at given values of the unknowns, always the same number of them, each divided by its standard
  /// deviation.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& values)> residuals;
  Eigen::VectorXd start;
  Eigen::VectorXd steps;  ///< step of numeric differentiation for each unknown; positive
  double huber = 2.0;     ///< residuals beyond this count linearly instead of by their square [Huber1964]
};

/// Result of a robust fit.
struct RobustFit {
  Eigen::VectorXd values;
  /// Inverse of the covariance of the values; singular if an unknown is undetermined.
  Eigen::MatrixXd information;
  double rms = 0.0;         ///< root mean square of the weighted residuals
  bool is_settled = false;  ///< whether the fit converged
};

/// Fits by the method of Levenberg and Marquardt [Marquardt1963] from the start values, with central
/// differences. Unknowns that the residuals do not determine keep their start values. Without unknowns only
/// the residuals are computed.
RobustFit fitRobustly(const FitProblem& problem);

/// The information matrix at the start values, without a fit.
Eigen::MatrixXd informationAt(const FitProblem& problem);

/// Robust standard deviation: 1.4826 times the median magnitude, which is the standard deviation of values
/// that are mostly normal about 0. 0 if there are no values.
double robustDeviation(std::vector<double> values);

}  // namespace lamina
