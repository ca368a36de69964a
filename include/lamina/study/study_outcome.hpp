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

/// What somebody published, or what was measured beside it.
struct ComparedRow {
  std::string name;
  std::vector<SettingText> values;  ///< by variable and response
};

/// What a study found.
struct StudyOutcome {
  std::vector<std::string> response_names;
  std::vector<Evaluation> evaluations;  ///< in the order of the search
  std::vector<Generation> generations;  ///< of NSGA-II
  std::optional<SurrogateSearch> surrogate;

  /// Of the front and of what was chosen: those of the search, or more.
  std::vector<std::string> front_response_names;
  std::vector<Evaluation> front;         ///< empty for a surrogate
  std::vector<double> decision_indices;  ///< one for each point of the front
  std::vector<SettingText> weights;      ///< of the decision, of all responses it looks at
  std::optional<Evaluation> chosen;      ///< none if nothing holds the constraints or has a weight
  std::vector<ComparedRow>
      compared;  ///< what was chosen, what was published, and what was measured beside it

  std::vector<std::string> notes;   ///< what a reader has to know besides
  std::vector<SettingText> search;  ///< settings as they were used
  int seed = 0;
  double wall_s = 0.0;
  std::string version;
};

/// How many could not be tried.
std::size_t failedCount(const std::vector<Evaluation>& evaluations);

/// Variables and responses of an evaluation as text; a response that is not a number is left out.
std::vector<SettingText> valuesOf(const DesignSpace& space, const std::vector<std::string>& response_names,
                                  const Evaluation& evaluation);

}  // namespace lamina
