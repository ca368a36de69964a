// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace lamina {

/// Unknowns to be found so that residuals become small.
struct FitProblem {
  /// As many residuals at any values, each in units of its own standard deviation.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& values)> residuals;
  Eigen::VectorXd start;
  Eigen::VectorXd steps;  ///< of numeric derivatives, one for each unknown; positive
  double huber = 2.0;     ///< residuals beyond count by their magnitude, not by their square [Huber1964]
};

/// What was found.
struct RobustFit {
  Eigen::VectorXd values;
  Eigen::MatrixXd information;  ///< inverse of the values' covariance, singular if one is undetermined
  double rms = 0.0;             ///< of the residuals, weighted
  bool is_settled = false;      ///< whether the steps became small
};

/// Fits by Levenberg and Marquardt [Marquardt1963] from the start, by central differences. Unknowns that
/// nothing determines stay where they are. No unknowns give the residuals alone.
RobustFit fitRobustly(const FitProblem& problem);

/// The information at the start, without fitting.
Eigen::MatrixXd informationAt(const FitProblem& problem);

/// 1.4826 times the median magnitude: the standard deviation of what is mostly normal about 0; 0 of nothing.
double robustDeviation(std::vector<double> values);

}  // namespace lamina
