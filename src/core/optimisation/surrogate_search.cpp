// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/surrogate_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/expected_improvement.hpp"
#include "lamina/optimisation/experiment_table.hpp"
#include "lamina/optimisation/response_surrogates.hpp"

namespace lamina {
namespace {

std::vector<double> valuesOf(const std::vector<Prediction>& predictions) {
  std::vector<double> values;
  values.reserve(predictions.size());
  for (const Prediction& prediction : predictions) values.push_back(prediction.value);
  return values;
}

/// What the search knows between two iterations.
class Search {
 public:
  Search(const SearchProblem& problem, const SurrogateFit& fit, const SurrogateSearchSettings& settings)
      : space_(problem.space),
        goals_(problem.goals),
        names_(problem.evaluator.responseNames()),
        evaluator_(problem.evaluator),
        fit_(fit),
        settings_(settings),
        counted_(countedResponses(goals_, names_)) {}

  SurrogateSearch run(std::vector<Evaluation> samples, const SurrogateListener& listener,
                      Progress& progress) {
    if (samples.empty())
      samples = evaluator_.evaluate(
          designExperiment(space_, settings_.design, static_cast<std::uint64_t>(settings_.seed)), {},
          progress);
    found_.design_size = samples.size();
    found_.evaluations = std::move(samples);
    learn();
    fitness_.emplace(goals_, names_, withMissingPredicted(found_.evaluations, *surrogates_));
    found_.best = bestFeasible(found_.evaluations, goals_, names_, *fitness_);
    for (int i = 1; i <= settings_.most_iterations; ++i) {
      throwIfCancelled(progress, "search");
      if (i > 1) learn();
      if (iterate(static_cast<std::size_t>(i), listener, progress)) break;
    }
    if (found_.best) found_.best_fitness = fitness_->valueOf(found_.evaluations[*found_.best].responses);
    return std::move(found_);
  }

 private:
  void learn() { surrogates_.emplace(space_, names_, found_.evaluations, fit_); }

  /// @return whether the search ends
  bool iterate(std::size_t index, const SurrogateListener& listener, Progress& progress) {
    SurrogateIteration iteration;
    iteration.index = index;
    iteration.surrogates = surrogates_->descriptions();
    iteration.proposed = proposal(index, progress);
    iteration.expected_improvement = improvementAt(iteration.proposed);
    measure(iteration, progress);
    judge(iteration);
    if (!iteration.is_sample) found_.evaluations.push_back(iteration.measured);
    found_.best = bestFeasible(found_.evaluations, goals_, names_, *fitness_);
    found_.iterations.push_back(iteration);
    if (listener) listener(iteration);
    return isDone(iteration);
  }

  bool isAmongFailed(const DesignPoint& point) const {
    return std::any_of(found_.evaluations.begin(), found_.evaluations.end(), [&](const Evaluation& tried) {
      return !isEvaluated(tried) && isNear(space_, point, tried.point, settings_.nearness);
    });
  }

  std::optional<double> bestCost() const {
    if (!found_.best) return std::nullopt;
    return fitness_->costOf(found_.evaluations[*found_.best].responses);
  }

  Merit predictedMerit(const DesignPoint& point) const {
    std::vector<double> responses(names_.size());
    for (const std::size_t k : counted_) responses[k] = surrogates_->of(k).valueAt(point);
    return {violationOf(goals_, names_, responses), fitness_->costOf(responses)};
  }

  /// Logarithms keep the order of gains too small for a number.
  Merit improvementMerit(const DesignPoint& point) const {
    constexpr double kLeast = 1e-300;
    std::vector<Prediction> predictions(names_.size());
    for (const std::size_t k : counted_) predictions[k] = surrogates_->of(k).at(point);
    double logarithm = 0.0;
    for (const Constraint& constraint : goals_.constraints) {
      const Prediction& prediction = predictions[responseIndex(names_, constraint.response)];
      logarithm += std::log(std::max(kLeast, probabilityWithin(constraint, prediction)));
    }
    if (const auto best = bestCost())
      logarithm +=
          std::log(std::max(kLeast, expectedImprovement(fitness_->predictedCost(predictions), *best)));
    return {0.0, -logarithm};
  }

  Merit meritOf(const DesignPoint& point) const {
    Merit merit = settings_.proposal == Proposal::Predicted ? predictedMerit(point) : improvementMerit(point);
    if (isAmongFailed(point)) merit.violation += 1.0;
    return merit;
  }

  double improvementAt(const DesignPoint& point) const {
    const auto best = bestCost();
    if (settings_.proposal == Proposal::Predicted || !best) return 0.0;
    return std::exp(-improvementMerit(point).cost);
  }

  DesignPoint proposal(std::size_t index, Progress& progress) const {
    const auto merit_of = [this](const DesignPoint& point) { return meritOf(point); };
    const Fittest fittest = searchGenetically(space_, merit_of, settings_.genetic,
                                              static_cast<std::uint64_t>(settings_.seed) + index, progress);
    return refined(space_, merit_of, fittest).point;
  }

  void measure(SurrogateIteration& iteration, Progress& progress) {
    for (const Evaluation& sample : withoutReplicates(found_.evaluations)) {
      if (!isNear(space_, iteration.proposed, sample.point, settings_.nearness)) continue;
      iteration.is_sample = true;
      iteration.measured = sample;
      return;
    }
    iteration.measured = evaluator_.evaluate({iteration.proposed}, {}, progress).at(0);
  }

  void judge(SurrogateIteration& iteration) const {
    const Evaluation& measured = iteration.measured;
    iteration.predictions = surrogates_->at(measured.point);
    const std::vector<double> predicted = valuesOf(iteration.predictions);
    iteration.predicted_fitness = fitness_->valueOf(predicted);
    iteration.predicted_violation = violationOf(goals_, names_, predicted);
    iteration.mape_percent = std::numeric_limits<double>::quiet_NaN();
    if (!isEvaluated(measured)) return;
    iteration.mape_percent =
        predictionErrorPercent(goals_, names_, measured.responses, iteration.predictions);
    iteration.is_feasible = violationOf(goals_, names_, measured.responses) == 0.0;
    // A sample that was learnt from is predicted exactly, which says nothing about the predictions.
    iteration.is_accepted = iteration.is_feasible && !iteration.is_sample &&
                            iteration.mape_percent < settings_.accepted_mape_percent;
  }

  bool isDone(const SurrogateIteration& last) {
    if (!isEvaluated(last.measured) && settings_.failed_proposal == FailedProposal::Stop)
      return endWith(SurrogateEnd::NotMeasured);
    if (last.is_sample) return endWith(SurrogateEnd::Sampled);
    if (static_cast<int>(last.index) < settings_.iterations) return false;
    if (settings_.proposal == Proposal::ExpectedImprovement) {
      const auto best = bestCost();
      if (best && last.expected_improvement < settings_.least_improvement_percent / 100.0 * std::abs(*best))
        return endWith(SurrogateEnd::NoImprovement);
      return false;
    }
    const auto& all = found_.iterations;
    if (std::any_of(all.begin(), all.end(), [](const auto& iteration) { return iteration.is_accepted; }))
      return endWith(SurrogateEnd::Accepted);
    return false;
  }

  bool endWith(SurrogateEnd end) {
    found_.end = end;
    return true;
  }

  const DesignSpace& space_;
  const Goals& goals_;
  const std::vector<std::string>& names_;
  Evaluator& evaluator_;
  const SurrogateFit& fit_;
  const SurrogateSearchSettings& settings_;
  std::vector<std::size_t> counted_;
  SurrogateSearch found_;
  std::optional<ResponseSurrogates> surrogates_;
  std::optional<Fitness> fitness_;
};

void requireUsableSearch(const std::vector<Evaluation>& samples, const DesignSpace& space,
                         std::size_t responses) {
  for (const Evaluation& sample : samples) {
    requireWithin(space, sample.point);
    if (isEvaluated(sample) && sample.responses.size() != responses)
      throw InvalidInput("a sample has " + std::to_string(sample.responses.size()) + " responses; expected " +
                         std::to_string(responses));
  }
}

}  // namespace

void describe(SettingsSchema& schema, SurrogateSearchSettings& settings) {
  describe(schema, settings.design);
  schema.choice(
      "surrogate.proposal", settings.proposal,
      {{"predicted", Proposal::Predicted}, {"expected_improvement", Proposal::ExpectedImprovement}},
      "Whether the point of best prediction is tried next, or that of greatest expected improvement.");
  schema.integer("surrogate.iterations", settings.iterations, {1, 100000},
                 "Proposed points to try at least, unless one has been tried already.");
  schema.integer("surrogate.most_iterations", settings.most_iterations, {1, 100000},
                 "Proposed points to try at most.");
  schema.number("surrogate.accepted_mape_percent", settings.accepted_mape_percent, Bounds::above(0.0, 100.0),
                "Mean absolute error of predictions below which a point is accepted.");
  schema.number("surrogate.least_improvement_percent", settings.least_improvement_percent, {0.0, 100.0},
                "Expected improvement of the best fitness below which the search ends.");
  schema.number("surrogate.nearness", settings.nearness, {0.0, 0.1},
                "Share of a continuous variable's range within which two points count as one.");
  schema.number("surrogate.answer_nearness", settings.answer_nearness, {0.0, 0.1},
                "The same, for a row of a table that answers a proposed point.");
  schema.choice("surrogate.failed_proposal", settings.failed_proposal,
                {{"avoid", FailedProposal::Avoid}, {"stop", FailedProposal::Stop}},
                "Whether another point is proposed after one that cannot be tried, or the search waits.");
  schema.integer("surrogate.seed", settings.seed, {0, 1000000000}, "Of the design and of the searches.");
  describe(schema, settings.genetic);
}

void requireConsistent(const SurrogateSearchSettings& settings) {
  if (settings.iterations > settings.most_iterations)
    throw InvalidConfig("surrogate.iterations is " + std::to_string(settings.iterations) +
                        "; expected at most surrogate.most_iterations, " +
                        std::to_string(settings.most_iterations));
}

const char* toString(SurrogateEnd end) {
  switch (end) {
    case SurrogateEnd::Accepted:
      return "accepted";
    case SurrogateEnd::Sampled:
      return "sampled";
    case SurrogateEnd::NoImprovement:
      return "no_improvement";
    case SurrogateEnd::Iterations:
      return "iterations";
    case SurrogateEnd::NotMeasured:
      return "not_measured";
  }
  return "unknown";
}

SurrogateSearch searchBySurrogate(const SearchProblem& problem, const Learning& learning,
                                  const SurrogateSearchSettings& settings, const SurrogateListener& listener,
                                  Progress& progress) {
  validate(problem);
  requireConsistent(settings);
  requireUsableSearch(learning.samples, problem.space, problem.evaluator.responseNames().size());
  return Search(problem, learning.fit, settings).run(learning.samples, listener, progress);
}

}  // namespace lamina
