// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/study.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::vector<std::string> namesInGoals(const Goals& goals) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Objective& objective : goals.objectives) add(objective.response);
  for (const Constraint& constraint : goals.constraints) add(constraint.response);
  return names;
}

}  // namespace

std::vector<std::string> responseNames(const Study& study) {
  if (study.commands) {
    std::vector<std::string> names;
    for (const CommandResponse& response : study.commands->responses) names.push_back(response.name);
    return names;
  }
  if (study.slice && !study.slice->metrics.empty()) return study.slice->metrics;
  return namesInGoals(study.goals);
}

Study ofPart(Study study, const std::string& part) {
  if (!study.slice)
    throw InvalidConfig("study '" + study.name +
                        "' slices no part; expected one with the key 'slice' for part '" + part + "'");
  study.slice->part = part;
  study.slice->parameters.clear();
  study.name += ", for " + part;
  study.published_source.clear();
  study.published.clear();
  return study;
}

}  // namespace lamina
