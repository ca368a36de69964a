// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/study/study_decision.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool weighs(const Criterion& criterion) { return criterion.weight > 0.0; }

bool isKnownEverywhere(const std::vector<Evaluation>& front, std::size_t response) {
  return std::all_of(front.begin(), front.end(), [&](const Evaluation& evaluation) {
    return std::isfinite(evaluation.responses.at(response));
  });
}

}  // namespace

std::vector<Criterion> decisionCriteria(const Study& study,
                                        const std::vector<std::string>& front_response_names) {
  std::vector<std::string> objectives;
  std::vector<std::string> maximised;
  for (const Objective& objective : study.goals.objectives) {
    objectives.push_back(objective.response);
    if (objective.sense == Sense::Maximise) maximised.push_back(objective.response);
  }
  std::vector<Criterion> criteria =
      criteriaOf(study.slice ? front_response_names : objectives, study.decision.weights, maximised);
  if (std::none_of(criteria.begin(), criteria.end(), weighs))
    throw InvalidConfig("all weights of the decision are 0; expected one that is greater");
  return criteria;
}

FrontDecision decideAmong(const std::vector<Evaluation>& front,
                          const std::vector<std::string>& response_names,
                          const std::vector<Criterion>& criteria, DecisionMethod method) {
  FrontDecision found;
  std::vector<Criterion> used;
  std::vector<std::vector<double>> responses(front.size());
  for (const Criterion& criterion : criteria) {
    const auto name = std::find(response_names.begin(), response_names.end(), criterion.response);
    if (!weighs(criterion) || name == response_names.end()) continue;
    const auto response = static_cast<std::size_t>(name - response_names.begin());
    if (!isKnownEverywhere(front, response)) {
      found.notes.push_back("decided without " + criterion.response + ", which is no number somewhere");
      continue;
    }
    used.push_back(criterion);
    for (std::size_t i = 0; i < front.size(); ++i) responses[i].push_back(front[i].responses[response]);
  }
  if (used.empty())
    found.notes.push_back("nothing is chosen: no response that has a weight is a number everywhere");
  else
    found.decision = decide(used, responses, method);
  return found;
}

}  // namespace lamina
