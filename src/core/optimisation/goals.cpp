// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/goals.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

double distanceFrom(const Constraint& constraint, double response) {
  if (std::isnan(response)) return std::numeric_limits<double>::infinity();
  const double bound = response < constraint.low ? constraint.low : constraint.high;
  if (response >= constraint.low && response <= constraint.high) return 0.0;
  return std::abs(response - bound) / std::max(1.0, std::abs(bound));
}

}  // namespace

std::size_t responseIndex(const std::vector<std::string>& response_names, const std::string& response) {
  const auto found = std::find(response_names.begin(), response_names.end(), response);
  if (found == response_names.end())
    throw InvalidConfig("no response '" + response + "'; there are " + listed(response_names));
  return static_cast<std::size_t>(found - response_names.begin());
}

void validate(const Goals& goals, const std::vector<std::string>& response_names) {
  if (goals.objectives.empty()) throw InvalidConfig("no objective; expected at least one");
  for (const Objective& objective : goals.objectives) {
    responseIndex(response_names, objective.response);
    if (!std::isfinite(objective.weight) || objective.weight < 0.0)
      throw InvalidConfig("objective " + objective.response + ": weight " + numberText(objective.weight) +
                          "; expected at least 0");
  }
  for (const Constraint& constraint : goals.constraints) {
    responseIndex(response_names, constraint.response);
    if (!(constraint.low <= constraint.high))
      throw InvalidConfig("constraint on " + constraint.response + ": from " + numberText(constraint.low) +
                          " to " + numberText(constraint.high) + " lies nothing");
  }
}

std::vector<double> costsOf(const Goals& goals, const std::vector<std::string>& response_names,
                            const std::vector<double>& responses) {
  std::vector<double> costs;
  for (const Objective& objective : goals.objectives) {
    const double response = responses.at(responseIndex(response_names, objective.response));
    costs.push_back(objective.sense == Sense::Minimise ? response : -response);
  }
  return costs;
}

double violationOf(const Goals& goals, const std::vector<std::string>& response_names,
                   const std::vector<double>& responses) {
  double violation = 0.0;
  for (const Constraint& constraint : goals.constraints)
    violation += distanceFrom(constraint, responses.at(responseIndex(response_names, constraint.response)));
  return violation;
}

}  // namespace lamina
