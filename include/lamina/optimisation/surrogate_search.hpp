// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/experiment_design.hpp"
#include "lamina/optimisation/fitness.hpp"
#include "lamina/optimisation/genetic_search.hpp"
#include "lamina/optimisation/search_problem.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// How the next point to be tried is chosen.
enum class Proposal {
  Predicted,            ///< best predicted fitness where all predicted responses keep to their intervals
  ExpectedImprovement,  ///< greatest expected gain over the best known point, times the probability that it
                        ///< is allowed
};

/// What follows if a proposed point cannot be tried.
enum class FailedProposal {
  Avoid,  ///< another point is proposed, not near it
  Stop,   ///< the search ends, for the point to be measured
};

/// Settings of a search that learns from the points it tried.
struct SurrogateSearchSettings {
  ExperimentDesignSettings design;
  GeneticSettings genetic;
  Proposal proposal = Proposal::Predicted;
  FailedProposal failed_proposal = FailedProposal::Avoid;
  int iterations = 4;  ///< least number, unless a proposed point is a sample already
  /// Greatest number; fewer if a point is accepted, or little improvement is expected.
  int most_iterations = 20;
  double accepted_mape_percent = 5.0;  ///< greatest error of the predictions of an accepted point
  /// ExpectedImprovement: share of the best fitness below which a search ends.
  double least_improvement_percent = 0.1;
  /// Share of a continuous variable's range within which two points count as one.
  double nearness = 1e-3;
  /// Share of a continuous variable's range by which a row of a table may differ from the proposed point that
  /// it answers, as machines are set to rounded values.
  double answer_nearness = 0.01;
  int seed = 1;
};

/// Adds the keys surrogate.* and genetic.*.
void describe(SettingsSchema& schema, SurrogateSearchSettings& settings);

/// @throws InvalidConfig if the greatest number of iterations is below the least
void requireConsistent(const SurrogateSearchSettings& settings);

/// An iteration of a search: the point that it proposed, what was predicted of it, and what was measured.
struct SurrogateIteration {
  std::size_t index = 0;  ///< number of the iteration, from 1
  DesignPoint proposed;
  std::vector<Prediction> predictions;  ///< of all responses, at the point that was measured
  double predicted_fitness = 0.0;
  double predicted_violation = 0.0;
  double expected_improvement = 0.0;  ///< of the fitness; 0 with `Proposal::Predicted`
  Evaluation measured;                ///< with its error if the point could not be tried
  bool is_sample = false;             ///< whether the point had been measured before
  bool is_feasible = false;           ///< whether measured responses keep to their intervals
  /// Mean absolute error of the predictions; not a number if the point could not be tried.
  double mape_percent = 0.0;
  bool is_accepted = false;             ///< whether it is feasible, predicted well enough, and no sample
  std::vector<std::string> surrogates;  ///< description for each response
};

/// Called with each iteration when it is done.
using SurrogateListener = std::function<void(const SurrogateIteration&)>;

/// The samples that a search learns from, and how surrogates are fitted.
struct Learning {
  SurrogateFit fit;
  std::vector<Evaluation> samples;  ///< tried already; if there are none, the design of the settings is tried
};

/// Why a search ended.
enum class SurrogateEnd {
  Accepted,       ///< a proposed point was accepted, after the least number of iterations
  Sampled,        ///< the proposed point is a sample already
  NoImprovement,  ///< less than the least improvement is expected
  Iterations,     ///< all iterations were used up
  NotMeasured,    ///< the last proposed point has yet to be measured
};

/// The end as written in reports and JSON: "accepted".
const char* toString(SurrogateEnd end);

/// What a search found.
struct SurrogateSearch {
  std::vector<Evaluation> evaluations;  ///< the design, then the proposed points
  std::size_t design_size = 0;          ///< number of evaluations that belong to the design
  std::vector<SurrogateIteration> iterations;
  std::optional<std::size_t> best;  ///< index of the evaluation of best fitness that keeps to all intervals
  double best_fitness = 0.0;        ///< fitness of `best`
  SurrogateEnd end = SurrogateEnd::Iterations;
};

/// Fits a surrogate to each response, proposes a point, tries it, adds it to the samples, and repeats
/// [Vega2023, chapter 6]; expected improvement as in [Jones1998], with constraints as in [Schonlau1997].
/// Missing responses of samples are predicted from samples that have them. Fitness is relative to the means
/// of the design: it is comparable between iterations.
/// @param listener  may be empty
/// @throws InvalidConfig as `validate`, `requireConsistent`, `Fitness` and the designs; InvalidInput if a
///   sample lies outside the space, or too few could be tried to fit a surrogate; Cancelled; what the
///   evaluator throws
SurrogateSearch searchBySurrogate(const SearchProblem& problem, const Learning& learning,
                                  const SurrogateSearchSettings& settings, const SurrogateListener& listener,
                                  Progress& progress);

}  // namespace lamina
