// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// Result of trying a point.
struct Evaluation {
  DesignPoint point;
  std::vector<double> responses;  ///< in the order of the evaluator's names; empty if it failed
  std::string error;              ///< why it failed; empty if it did not
};

/// Whether the point could be tried.
inline bool isEvaluated(const Evaluation& evaluation) { return evaluation.error.empty(); }

/// Called with every evaluation as it is done: one at a time, in any order, from any thread.
using EvaluationListener = std::function<void(const Evaluation&)>;

/// Interface through which a search tries points: by slicing, by a command, on other machines.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// Names of the responses that are measured at each point.
  virtual const std::vector<std::string>& responseNames() const = 0;

  /// Tries all points. The evaluator chooses how many it tries at a time; the result does not depend on that
  /// number.
  /// @param done  is called with each evaluation; may be empty
  /// @return one evaluation for each point, in the order of the points; that of a point that cannot be tried
  ///   holds the error
  /// @throws Cancelled, after `done` was called with the evaluations that were finished
  virtual std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points,
                                           const EvaluationListener& done, Progress& progress) = 0;
};

/// Measures one point.
/// @throws Error if that is not possible
using PointMeasurement = std::function<std::vector<double>(const DesignPoint& point, Progress& progress)>;

/// Tries points on all threads of this machine.
class ParallelEvaluator final : public Evaluator {
 public:
  /// @param measure  called from several threads at once; returns as many numbers as there are names
  ParallelEvaluator(std::vector<std::string> response_names, PointMeasurement measure);

  const std::vector<std::string>& responseNames() const override { return names_; }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

 private:
  std::vector<std::string> names_;
  PointMeasurement measure_;
};

}  // namespace lamina
