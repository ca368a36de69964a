// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/decision.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

using Rows = std::vector<std::vector<double>>;

void requireUsableWeights(const Rows& costs, const std::vector<double>& weights) {
  if (costs.empty()) throw InvalidInput("no alternative to choose from; expected at least one");
  for (const double weight : weights)
    if (!std::isfinite(weight) || weight < 0.0)
      throw InvalidConfig("weight " + numberText(weight) + "; expected at least 0");
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0.0; }))
    throw InvalidConfig("all weights are 0; expected one that is greater");
  for (std::size_t row = 0; row < costs.size(); ++row) {
    const std::string alternative = "alternative " + std::to_string(row + 1);
    if (costs[row].size() != weights.size())
      throw InvalidInput(alternative + " has " + std::to_string(costs[row].size()) + " costs; expected " +
                         std::to_string(weights.size()));
    for (const double cost : costs[row])
      if (!std::isfinite(cost))
        throw InvalidInput(alternative + " has a cost " + numberText(cost) + "; must be finite");
  }
}

/// Each column relative to its greatest magnitude.
Rows normalised(Rows costs) {
  for (std::size_t column = 0; column < costs[0].size(); ++column) {
    double greatest = 0.0;
    for (const auto& row : costs) greatest = std::max(greatest, std::abs(row[column]));
    if (greatest > 0.0)
      for (auto& row : costs) row[column] /= greatest;
  }
  return costs;
}

/// Of each column, its least or greatest value.
template <class Chosen>
std::vector<double> extremes(const Rows& rows, const Chosen& chosen) {
  std::vector<double> extreme = rows[0];
  for (const auto& row : rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      extreme[column] = chosen(extreme[column], row[column]);
  return extreme;
}

std::vector<double> leastOf(const Rows& rows) {
  return extremes(rows, [](double a, double b) { return std::min(a, b); });
}

std::vector<double> greatestOf(const Rows& rows) {
  return extremes(rows, [](double a, double b) { return std::max(a, b); });
}

double distance(const std::vector<double>& one, const std::vector<double>& other,
                const std::vector<double>& weights) {
  double squares = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
    squares += weights[i] * (one[i] - other[i]) * (one[i] - other[i]);
  return std::sqrt(squares);
}

Decision decideByLinmap(const Rows& rows, const std::vector<double>& weights) {
  std::vector<double> ideal = leastOf(rows);
  for (double& cost : ideal) cost = std::min(cost, 0.0);
  Decision decision;
  for (const auto& row : rows) decision.indices.push_back(distance(row, ideal, weights));
  const auto best = std::min_element(decision.indices.begin(), decision.indices.end());
  decision.chosen = static_cast<std::size_t>(best - decision.indices.begin());
  return decision;
}

Decision decideByTopsis(const Rows& rows, const std::vector<double>& weights) {
  const std::vector<double> ideal = leastOf(rows);
  const std::vector<double> worst = greatestOf(rows);
  Decision decision;
  for (const auto& row : rows) {
    const double from_ideal = distance(row, ideal, weights);
    const double from_worst = distance(row, worst, weights);
    const double both = from_ideal + from_worst;
    decision.indices.push_back(both > 0.0 ? from_worst / both : 1.0);
  }
  const auto best = std::max_element(decision.indices.begin(), decision.indices.end());
  decision.chosen = static_cast<std::size_t>(best - decision.indices.begin());
  return decision;
}

}  // namespace

Decision decide(const std::vector<std::vector<double>>& costs, const std::vector<double>& weights,
                DecisionMethod method) {
  requireUsableWeights(costs, weights);
  const Rows rows = normalised(costs);
  return method == DecisionMethod::Linmap ? decideByLinmap(rows, weights) : decideByTopsis(rows, weights);
}

}  // namespace lamina
