// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/optimisation/nsga2.hpp"
#include "lamina/optimisation/surrogate_search.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// A row of the comparison: the chosen point, a published one or a baseline.
struct ComparedRow {
  std::string name;
  std::vector<SettingText> values;  ///< by variable and response
};

/// Result of a study.
struct StudyOutcome {
  std::vector<std::string> response_names;
  std::vector<Evaluation> evaluations;       ///< in the order of the search
  std::vector<Generation> generations;       ///< of NSGA-II; empty for a surrogate
  std::optional<SurrogateSearch> surrogate;  ///< nothing for NSGA-II

  /// Names of the responses of the front and of the chosen point: those of the search, possibly with more.
  std::vector<std::string> front_response_names;
  std::vector<Evaluation> front;         ///< empty for a surrogate
  std::vector<double> decision_indices;  ///< index of the decision method for each point of the front
  std::vector<SettingText> weights;      ///< weights of the decision, by response
  std::optional<Evaluation> chosen;  ///< nothing if no point satisfies the constraints, or there is no weight
  std::vector<ComparedRow> compared;  ///< the chosen point, published ones and baselines
  std::vector<std::string> notes;     ///< further notes for the reader

  std::vector<SettingText> search;  ///< search settings that were used
  int seed = 0;                     ///< of the search
  double wall_s = 0.0;              ///< duration
  std::string version;              ///< of this program
};
/// Number of evaluations that failed.
std::size_t failedCount(const std::vector<Evaluation>& evaluations);

/// Variables and responses of an evaluation as text; responses that are not finite are omitted.
std::vector<SettingText> valuesOf(const DesignSpace& space, const std::vector<std::string>& response_names,
                                  const Evaluation& evaluation);

}  // namespace lamina
