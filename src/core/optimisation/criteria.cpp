// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/criteria.hpp"

#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

double usualWeight(const std::string& response) {
  return response == "under_fill_mm2" || response == "volume_error_mm3" ? 3.0 : 1.0;
}

double weightIn(const SettingText& weight) {
  double value = 0.0;
  const char* end = weight.text.data() + weight.text.size();
  const auto result = std::from_chars(weight.text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value) || value < 0.0)
    throw InvalidConfig("weight of " + weight.key + " is '" + weight.text + "'; must be a number from 0");
  return value;
}

}  // namespace

std::vector<Criterion> criteriaOf(const std::vector<std::string>& response_names,
                                  const std::vector<SettingText>& weights,
                                  const std::vector<std::string>& maximised) {
  std::vector<Criterion> criteria;
  criteria.reserve(response_names.size());
  for (const std::string& name : response_names)
    criteria.push_back({name, usualWeight(name), Sense::Minimise});
  for (const SettingText& weight : weights)
    criteria[responseIndex(response_names, weight.key)].weight = weightIn(weight);
  for (const std::string& name : maximised)
    criteria[responseIndex(response_names, name)].sense = Sense::Maximise;
  return criteria;
}

Decision decide(const std::vector<Criterion>& criteria, const std::vector<std::vector<double>>& responses,
                DecisionMethod method) {
  std::vector<double> weights;
  for (const Criterion& criterion : criteria)
    if (criterion.weight > 0.0) weights.push_back(criterion.weight);
  std::vector<std::vector<double>> costs(responses.size());
  for (std::size_t row = 0; row < responses.size(); ++row)
    for (std::size_t i = 0; i < criteria.size(); ++i) {
      if (criteria[i].weight == 0.0) continue;
      const double response = responses[row].at(i);
      if (!std::isfinite(response))
        throw InvalidInput("alternative " + std::to_string(row + 1) + " has no " + criteria[i].response +
                           "; expected a number, or weight 0");
      costs[row].push_back(criteria[i].sense == Sense::Minimise ? response : -response);
    }
  return decide(costs, weights, method);
}

DecisionMethod decisionMethodOf(const std::string& name) {
  if (name == "linmap") return DecisionMethod::Linmap;
  if (name == "topsis") return DecisionMethod::Topsis;
  throw InvalidConfig("method of decision '" + name + "'; expected linmap or topsis");
}

}  // namespace lamina
