// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/evaluation.hpp"

#include <mutex>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/optimisation/measured_point.hpp"

namespace lamina {
namespace {

/// Progress of one point among many: only the cancelling passes.
class QuietProgress final : public Progress {
 public:
  explicit QuietProgress(const Progress& outer) : outer_(outer) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return outer_.isCancelled(); }

 private:
  const Progress& outer_;
};

}  // namespace

Evaluation measuredPoint(DesignPoint point, std::vector<double> responses,
                         const std::vector<std::string>& names) {
  if (responses.size() == names.size()) return {std::move(point), std::move(responses), {}};
  return {std::move(point),
          {},
          std::to_string(responses.size()) + " responses were measured; expected " +
              std::to_string(names.size())};
}

ParallelEvaluator::ParallelEvaluator(std::vector<std::string> response_names, PointMeasurement measure)
    : names_(std::move(response_names)), measure_(std::move(measure)) {}

std::vector<Evaluation> ParallelEvaluator::evaluate(const std::vector<DesignPoint>& points,
                                                    const EvaluationListener& done, Progress& progress) {
  std::vector<Evaluation> evaluations(points.size());
  std::mutex reporting;
  const auto evaluateOne = [&](std::size_t i) {
    QuietProgress quiet(progress);
    Evaluation& evaluation = evaluations[i];
    try {
      evaluation = measuredPoint(points[i], measure_(points[i], quiet), names_);
    } catch (const Cancelled&) {
      throw;
    } catch (...) {
      evaluation = {points[i], {}, currentFailure().message};
    }
    const std::lock_guard<std::mutex> lock(reporting);
    if (done) done(evaluation);
  };
  parallelFor(points.size(), evaluateOne, progress, "evaluate");
  return evaluations;
}

}  // namespace lamina
