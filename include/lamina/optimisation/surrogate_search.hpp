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

/// How the next point to try is chosen.
enum class Proposal {
  Predicted,            ///< best predicted fitness where all predicted responses keep to their intervals
  ExpectedImprovement,  ///< greatest expected gain over the best point known, times how probably it is
                        ///< allowed
};

/// What follows a proposed point that cannot be tried.
enum class FailedProposal {
  Avoid,  ///< another point is proposed, not near it
  Stop,   ///< the search waits: somebody has to measure it
};

/// A search that learns from the points it tried.
struct SurrogateSearchSettings {
  ExperimentDesignSettings design;
  GeneticSettings genetic;
  Proposal proposal = Proposal::Predicted;
  FailedProposal failed_proposal = FailedProposal::Avoid;
  int iterations = 4;        ///< at least, unless a proposed point is a sample already
  int most_iterations = 20;  ///< ends before if a point is accepted, or little improvement is expected
  double accepted_mape_percent = 5.0;
  double least_improvement_percent = 0.1;  ///< ExpectedImprovement: of the best fitness; stops below
  /// Share of a continuous variable's range within which two points count as one.
  double nearness = 1e-3;
  /// The same, for a row of a table that answers a proposed point: machines are set to rounded values.
  double answer_nearness = 0.01;
  int seed = 1;
};

/// Adds the keys surrogate.* and genetic.*.
void describe(SettingsSchema& schema, SurrogateSearchSettings& settings);

/// @throws InvalidConfig if fewer iterations are allowed than asked for at least
void requireConsistent(const SurrogateSearchSettings& settings);

/// A point proposed on what was known before it, and what came of it.
struct SurrogateIteration {
  std::size_t index = 0;  ///< from 1
  DesignPoint proposed;
  std::vector<Prediction> predictions;  ///< of all responses, at the point that was measured
  double predicted_fitness = 0.0;
  double predicted_violation = 0.0;
  double expected_improvement = 0.0;    ///< of the fitness; 0 if predictions alone decided
  Evaluation measured;                  ///< with its error if the point could not be tried
  bool is_sample = false;               ///< whether it had been measured before
  bool is_feasible = false;             ///< whether measured responses keep to their intervals
  double mape_percent = 0.0;            ///< of predictions; not a number if it could not be tried
  bool is_accepted = false;             ///< feasible, predicted well enough, and no sample
  std::vector<std::string> surrogates;  ///< description for each response
};

/// Reported of each iteration when it is done.
using SurrogateListener = std::function<void(const SurrogateIteration&)>;

/// What a search learns from, and how.
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
  NotMeasured,    ///< the last proposed point waits for its results
};

/// The end as written in reports and JSON: "accepted".
const char* toString(SurrogateEnd end);

struct SurrogateSearch {
  std::vector<Evaluation> evaluations;  ///< the design, then the proposed points
  std::size_t design_size = 0;
  std::vector<SurrogateIteration> iterations;
  std::optional<std::size_t> best;  ///< evaluation of best fitness that keeps to all intervals
  double best_fitness = 0.0;        ///< of it
  SurrogateEnd end = SurrogateEnd::Iterations;
};

/// Fits a surrogate to each response, proposes a point, tries it, learns from it, and so on
/// [Vega2023, chapter 6]; expected improvement as in [Jones1998], with constraints as in [Schonlau1997].
/// Missing responses of samples are predicted from those that have them. Fitness is relative to the means of
/// the design, so that it means the same in all iterations.
/// @param listener  may be empty
/// @throws InvalidConfig as `validate`, `requireConsistent`, `Fitness` and the designs; InvalidInput if a
///   sample lies outside the space, or too few could be tried to fit a surrogate; Cancelled; what the
///   evaluator throws
SurrogateSearch searchBySurrogate(const SearchProblem& problem, const Learning& learning,
                                  const SurrogateSearchSettings& settings, const SurrogateListener& listener,
                                  Progress& progress);

}  // namespace lamina
