// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/optimisation/criteria.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// What a point of the study's front is chosen by: all metrics of a part; else the objectives.
/// @param front_response_names  what is measured of a front
/// @throws InvalidConfig as `criteriaOf`; if no weight is greater than 0
std::vector<Criterion> decisionCriteria(const Study& study,
                                        const std::vector<std::string>& front_response_names);

/// A choice, if one can be made, and what a reader has to know of it.
struct FrontDecision {
  std::optional<Decision> decision;
  std::vector<std::string> notes;
};

/// Decides by those criteria that are among the responses, and numbers at every point of the front; the
/// others that weigh something become notes. Without any that weighs something nothing is chosen.
/// @param front  not empty
FrontDecision decideAmong(const std::vector<Evaluation>& front,
                          const std::vector<std::string>& response_names,
                          const std::vector<Criterion>& criteria, DecisionMethod method);

}  // namespace lamina
