// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/fitness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

struct Mean {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double value) {
    if (!std::isfinite(value)) return;
    sum += value;
    ++count;
  }
  double value() const {
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
  }
};

bool hasResponse(const Evaluation& evaluation) {
  return isEvaluated(evaluation) && std::any_of(evaluation.responses.begin(), evaluation.responses.end(),
                                                [](double response) { return std::isfinite(response); });
}

}  // namespace

std::vector<Evaluation> withoutReplicates(const std::vector<Evaluation>& samples) {
  std::map<DesignPoint, std::size_t> place_of;
  std::vector<Evaluation> unique;
  std::vector<std::vector<Mean>> means;
  for (const Evaluation& sample : samples) {
    if (!hasResponse(sample)) continue;
    const auto [place, is_new] = place_of.emplace(sample.point, unique.size());
    if (is_new) {
      unique.push_back(sample);
      means.emplace_back(sample.responses.size());
    }
    for (std::size_t k = 0; k < sample.responses.size(); ++k)
      means[place->second].at(k).add(sample.responses[k]);
  }
  for (std::size_t i = 0; i < unique.size(); ++i)
    for (std::size_t k = 0; k < unique[i].responses.size(); ++k) unique[i].responses[k] = means[i][k].value();
  return unique;
}

Fitness::Fitness(const Goals& goals, const std::vector<std::string>& response_names,
                 const std::vector<Evaluation>& design) {
  validate(goals, response_names);
  const auto weighted = std::find_if(goals.objectives.begin(), goals.objectives.end(),
                                     [](const Objective& objective) { return objective.weight > 0.0; });
  if (weighted == goals.objectives.end())
    throw InvalidConfig("all objectives have weight 0; expected one that counts");
  sense_ = weighted->sense;
  const std::vector<Evaluation> unique = withoutReplicates(design);
  for (const Objective& objective : goals.objectives) {
    if (objective.weight == 0.0) continue;
    const std::size_t k = responseIndex(response_names, objective.response);
    Mean mean;
    for (const Evaluation& sample : unique) mean.add(sample.responses.at(k));
    if (mean.count == 0 || mean.value() == 0.0)
      throw InvalidInput("response " + objective.response + " has " +
                         (mean.count == 0 ? "no value" : "the mean 0") +
                         " in the design; its weight is relative to a mean that is not 0");
    const double sign = objective.sense == Sense::Minimise ? 1.0 : -1.0;
    terms_.push_back({k, sign * objective.weight / std::abs(mean.value())});
  }
}

double Fitness::costOf(const std::vector<double>& responses) const {
  double cost = 0.0;
  for (const Term& term : terms_) cost += term.factor * responses.at(term.response);
  return cost;
}

double Fitness::valueOf(const std::vector<double>& responses) const {
  return sense_ == Sense::Minimise ? costOf(responses) : -costOf(responses);
}

Prediction Fitness::predictedCost(const std::vector<Prediction>& predictions) const {
  Prediction cost;
  for (const Term& term : terms_) {
    const Prediction& prediction = predictions.at(term.response);
    cost.value += term.factor * prediction.value;
    cost.variance += term.factor * term.factor * prediction.variance;
  }
  return cost;
}

std::optional<std::size_t> bestFeasible(const std::vector<Evaluation>& samples, const Goals& goals,
                                        const std::vector<std::string>& response_names,
                                        const Fitness& fitness) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!isEvaluated(samples[i]) || violationOf(goals, response_names, samples[i].responses) > 0.0) continue;
    const double cost = fitness.costOf(samples[i].responses);
    if (!(cost < least)) continue;
    least = cost;
    best = i;
  }
  return best;
}

std::vector<std::size_t> countedResponses(const Goals& goals,
                                          const std::vector<std::string>& response_names) {
  std::set<std::size_t> counted;
  for (const Objective& objective : goals.objectives)
    if (objective.weight > 0.0) counted.insert(responseIndex(response_names, objective.response));
  for (const Constraint& constraint : goals.constraints)
    counted.insert(responseIndex(response_names, constraint.response));
  return {counted.begin(), counted.end()};
}

double predictionErrorPercent(const Goals& goals, const std::vector<std::string>& response_names,
                              const std::vector<double>& measured, const std::vector<Prediction>& predicted) {
  double sum = 0.0;
  const std::vector<std::size_t> counted = countedResponses(goals, response_names);
  for (const std::size_t k : counted) {
    const double error = std::abs(measured.at(k) - predicted.at(k).value);
    if (error == 0.0) continue;
    if (!std::isfinite(error) || measured[k] == 0.0) return std::numeric_limits<double>::infinity();
    sum += error / std::abs(measured[k]);
  }
  return 100.0 * sum / static_cast<double>(counted.size());
}

}  // namespace lamina
