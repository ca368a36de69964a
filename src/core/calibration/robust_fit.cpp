// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robust_fit.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense_solvers.hpp"

namespace lamina {
namespace {

constexpr int kMostSteps = 60;
constexpr double kFirstDamping = 1e-4;
constexpr double kGreatestDamping = 1e10;
constexpr double kSettled = 1e-5;  // of a step of the derivatives

double huberCost(const Eigen::VectorXd& residuals, double bound) {
  double cost = 0.0;
  for (const double residual : residuals) {
    const double size = std::abs(residual);
    cost += size <= bound ? 0.5 * size * size : bound * (size - 0.5 * bound);
  }
  return cost;
}

/// Roots of the weights by which squares become Huber's loss.
Eigen::ArrayXd rootWeights(const Eigen::VectorXd& residuals, double bound) {
  return residuals.array().abs().max(bound).inverse().sqrt() * std::sqrt(bound);
}

Eigen::MatrixXd derivatives(const FitProblem& problem, const Eigen::VectorXd& values, Eigen::Index rows) {
  Eigen::MatrixXd jacobian(rows, values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    Eigen::VectorXd beside = values;
    beside[i] = values[i] + problem.steps[i];
    const Eigen::VectorXd after = problem.residuals(beside);
    beside[i] = values[i] - problem.steps[i];
    jacobian.col(i) = (after - problem.residuals(beside)) / (2.0 * problem.steps[i]);
  }
  return jacobian;
}

/// The normal equations at some values.
struct NormalEquations {
  Eigen::MatrixXd information;
  Eigen::VectorXd slope;
};

NormalEquations normalEquations(const FitProblem& problem, const Eigen::VectorXd& values,
                                const Eigen::VectorXd& residuals) {
  const Eigen::ArrayXd weights = rootWeights(residuals, problem.huber);
  const Eigen::MatrixXd jacobian =
      (derivatives(problem, values, residuals.size()).array().colwise() * weights).matrix();
  const Eigen::VectorXd weighted = (residuals.array() * weights).matrix();
  return {jacobian.transpose() * jacobian, jacobian.transpose() * weighted};
}

/// Damped in the units of the derivatives' steps, so that what nothing determines stays.
Eigen::VectorXd dampedStep(const NormalEquations& equations, const FitProblem& problem, double damping) {
  const Eigen::VectorXd units = problem.steps;
  Eigen::MatrixXd scaled = units.asDiagonal() * equations.information * units.asDiagonal();
  const double greatest = scaled.diagonal().maxCoeff();
  scaled.diagonal().array() *= 1.0 + damping;
  scaled.diagonal().array() += 1e-12 * greatest + 1e-300;
  const Eigen::VectorXd step = symmetricSolution(scaled, units.asDiagonal() * equations.slope);
  return -(units.asDiagonal() * step);
}

}  // namespace

RobustFit fitRobustly(const FitProblem& problem) {
  RobustFit fit;
  fit.values = problem.start;
  Eigen::VectorXd residuals = problem.residuals(fit.values);
  double cost = huberCost(residuals, problem.huber);
  double damping = kFirstDamping;
  for (int i = 0; i < kMostSteps && fit.values.size() > 0 && !fit.is_settled; ++i) {
    const NormalEquations equations = normalEquations(problem, fit.values, residuals);
    while (damping < kGreatestDamping) {
      const Eigen::VectorXd step = dampedStep(equations, problem, damping);
      const Eigen::VectorXd tried = problem.residuals(fit.values + step);
      const double tried_cost = huberCost(tried, problem.huber);
      const bool is_small = ((step.array() / problem.steps.array()).abs() < kSettled).all();
      if (std::isfinite(tried_cost) && tried_cost <= cost) {
        fit.values += step;
        residuals = tried;
        cost = tried_cost;
        damping = std::max(1e-9, 0.2 * damping);
        fit.is_settled = is_small;
        break;
      }
      if (is_small) {
        fit.is_settled = true;
        break;
      }
      damping *= 5.0;
    }
    if (damping >= kGreatestDamping) fit.is_settled = true;
  }
  fit.information = normalEquations(problem, fit.values, residuals).information;
  const Eigen::ArrayXd weighted = residuals.array() * rootWeights(residuals, problem.huber);
  fit.rms = residuals.size() > 0 ? std::sqrt(weighted.square().mean()) : 0.0;
  return fit;
}

Eigen::MatrixXd informationAt(const FitProblem& problem) {
  return normalEquations(problem, problem.start, problem.residuals(problem.start)).information;
}

double robustDeviation(std::vector<double> values) {
  if (values.empty()) return 0.0;
  for (double& value : values) value = std::abs(value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return 1.4826 * *middle;
}

}  // namespace lamina
