// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/feeder_fit.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "base/dense_solvers.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "robust_fit.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLeastSections = 20;
constexpr double kLeastGain = 0.1;  // sections that follow the steps by less do not follow them
constexpr double kTriedStepS = 0.02;
constexpr std::array<double, 6> kTriedLags = {0.01, 0.1, 0.2, 0.4, 0.8, 1.6};  // s
constexpr double kShortestLag = 1e-4;                                          // s

/// The unknowns, in their order.
enum : Eigen::Index { kDeadTime, kLag, kShift, kGain, kLevels };

/// A delay that is tried.
struct FeederDelayTried {
  double dead_time_s = 0.0;
  double lag_s = 0.0;
};

/// Place of the first piece's middle along the bead: from there on what was deposited before plays no part.
double firstUsed(const FeederSteps& steps) {
  const double length = (steps.beads[0].end - steps.beads[0].start).norm();
  return 0.5 * length / static_cast<double>(steps.amount.size());
}

/// Integral over time of the response to a step at 0.
double integratedResponse(double time_s, double lag_s) {
  if (time_s <= 0.0) return 0.0;
  const double lag = std::max(lag_s, kShortestLag);
  return time_s - lag * (1.0 - std::exp(-time_s / lag));
}

/// The relative amount that arrives less that of the first piece, as a mean over a section that takes so
/// long.
double arrived(const FeederSteps& steps, double time_s, double section_s, double step_s,
               const FeederDelayTried& tried) {
  double amount = 0.0;
  for (std::size_t i = 1; i < steps.amount.size(); ++i) {
    const double end_s = time_s + 0.5 * section_s - tried.dead_time_s - step_s * static_cast<double>(i);
    if (end_s <= 0.0) break;
    amount += (steps.amount[i] - steps.amount[i - 1]) *
              (integratedResponse(end_s, tried.lag_s) - integratedResponse(end_s - section_s, tried.lag_s)) /
              section_s;
  }
  return amount;
}

/// Sections beside what commanded them.
struct FeederProblem {
  const FeederSteps& steps;
  const std::vector<BeadCrossSections>& beads;
  double speed_mm_s = 1.0;
  double step_s = 1.0;
  double area_mm2 = 1.0;  ///< standard deviation of a section

  double arrivedAt(double along_mm, const Eigen::VectorXd& values, std::size_t bead) const {
    // Against the direction of the first bead, a shift of the scan counts the other way.
    const double sense = bead % 2 == 0 ? 1.0 : -1.0;
    const double time_s = (along_mm - sense * values[kShift]) / speed_mm_s;
    return arrived(steps, time_s, kCrossSectionLengthMm / speed_mm_s, step_s,
                   {values[kDeadTime], std::abs(values[kLag])});
  }

  Eigen::VectorXd residuals(const Eigen::VectorXd& values) const {
    std::vector<double> found;
    for (std::size_t b = 0; b < beads.size(); ++b)
      for (std::size_t i = 0; i < beads[b].along_mm.size(); ++i) {
        if (beads[b].along_mm[i] < firstUsed(steps)) continue;
        const double level = values[kLevels + static_cast<Eigen::Index>(b)];
        const double expected = level * (1.0 + values[kGain] * arrivedAt(beads[b].along_mm[i], values, b));
        found.push_back((beads[b].area_mm2[i] - expected) / area_mm2);
      }
    return Eigen::Map<Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(found.size()));
  }
};

/// Levels and gain that fit best at a dead time and lag, and the squares that are left.
struct LinearFit {
  Eigen::VectorXd values;
  double squares = std::numeric_limits<double>::infinity();
};

LinearFit linearFit(const FeederProblem& problem, double dead_time_s, double lag_s) {
  LinearFit fit;
  const auto beads = static_cast<Eigen::Index>(problem.beads.size());
  fit.values = Eigen::VectorXd::Zero(kLevels + beads);
  fit.values[kDeadTime] = dead_time_s;
  fit.values[kLag] = lag_s;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(beads + 1, beads + 1);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(beads + 1);
  double squares = 0.0;
  for (std::size_t b = 0; b < problem.beads.size(); ++b)
    for (std::size_t i = 0; i < problem.beads[b].along_mm.size(); ++i) {
      const double along = problem.beads[b].along_mm[i];
      if (along < firstUsed(problem.steps)) continue;
      Eigen::VectorXd row = Eigen::VectorXd::Zero(beads + 1);
      row[static_cast<Eigen::Index>(b)] = 1.0;
      row[beads] = problem.arrivedAt(along, fit.values, b);
      normal += row * row.transpose();
      right += row * problem.beads[b].area_mm2[i];
      squares += problem.beads[b].area_mm2[i] * problem.beads[b].area_mm2[i];
    }
  const Eigen::VectorXd found = symmetricSolution(normal, right);
  fit.squares = squares - found.dot(right);
  fit.values.tail(beads) = found.head(beads);
  fit.values[kGain] = found[beads] * static_cast<double>(beads) / found.head(beads).sum();
  return fit;
}

/// The best of dead times up to the duration of a step, and of a few lags.
Eigen::VectorXd firstGuess(const FeederProblem& problem) {
  LinearFit best;
  for (double dead_time = 0.0; dead_time < problem.step_s;
       dead_time += std::max(kTriedStepS, problem.step_s / 500.0))
    for (const double lag : kTriedLags) {
      LinearFit fit = linearFit(problem, dead_time, lag);
      if (fit.squares < best.squares) best = std::move(fit);
    }
  if (best.values.size() == 0 || !best.values.allFinite() || !(best.values[kGain] > kLeastGain))
    throw InvalidInput("the beads' sections do not follow the steps of the feeder; expected a gain above " +
                       numberText(kLeastGain) + ": are place, step and speed those of the program?");
  return best.values;
}

void requireSections(const std::vector<BeadCrossSections>& beads) {
  for (std::size_t i = 0; i < beads.size(); ++i)
    if (beads[i].along_mm.size() < kLeastSections)
      throw InvalidInput("bead " + std::to_string(i + 1) + " of the feeder is seen at " +
                         std::to_string(beads[i].along_mm.size()) + " places; expected at least " +
                         std::to_string(kLeastSections));
}

Eigen::VectorXd stepsOf(const Eigen::VectorXd& values) {
  Eigen::VectorXd steps = Eigen::VectorXd::Constant(values.size(), 1e-3);
  steps.tail(values.size() - kLevels) = 1e-3 * values.tail(values.size() - kLevels).cwiseAbs();
  return steps;
}

}  // namespace

FeederFit fitFeeder(const FeederSteps& steps, const std::vector<BeadCrossSections>& beads,
                    double speed_mm_s) {
  requireSections(beads);
  FeederProblem problem{steps, beads, speed_mm_s, 2.0 * firstUsed(steps) / speed_mm_s, 1.0};
  Eigen::VectorXd values = firstGuess(problem);
  RobustFit found;
  for (int round = 0; round < 3; ++round) {
    problem.area_mm2 = 1.0;
    const Eigen::VectorXd residuals = problem.residuals(values);
    problem.area_mm2 = std::max(1e-6 * values[kLevels],
                                robustDeviation({residuals.data(), residuals.data() + residuals.size()}));
    FitProblem fit;
    fit.start = values;
    fit.steps = stepsOf(values);
    fit.residuals = [&problem](const Eigen::VectorXd& tried) { return problem.residuals(tried); };
    found = fitRobustly(fit);
    values = found.values;
  }
  if (!(values[kDeadTime] < problem.step_s && values[kGain] > kLeastGain))
    throw InvalidInput("the dead time is " + numberText(values[kDeadTime]) + " s at a gain of " +
                       numberText(values[kGain]) + "; expected less than the " + numberText(problem.step_s) +
                       " s that a step takes: longer steps or less speed");
  // A lag too short to be seen is known to be shorter than a step.
  found.information(kLag, kLag) += 1.0 / (problem.step_s * problem.step_s);
  const Eigen::MatrixXd covariance =
      symmetricSolution(found.information, Eigen::MatrixXd::Identity(values.size(), values.size()));
  FeederFit result;
  result.dead_time_s = std::max(0.0, values[kDeadTime]);
  result.dead_time_spread_s = std::sqrt(std::max(0.0, covariance(kDeadTime, kDeadTime)));
  result.lag_s = std::abs(values[kLag]);
  result.lag_spread_s = std::sqrt(std::max(0.0, covariance(kLag, kLag)));
  result.gain = values[kGain];
  result.shift_mm = values[kShift];
  result.rms = found.rms * problem.area_mm2 / values[kLevels];
  for (const BeadCrossSections& bead : beads) result.sections += bead.along_mm.size();
  return result;
}

}  // namespace lamina
