// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <pagmo/utils/hypervolume.hpp>
#include <pagmo/utils/multi_objective.hpp>

namespace lamina {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Costs = std::vector<std::vector<double>>;

Front feasibleOf(const std::vector<Score>& scores) {
  Front feasible;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (isFeasible(scores[i])) feasible.push_back(i);
  return feasible;
}

Costs costsOf(const std::vector<Score>& scores, const Front& front) {
  Costs costs;
  costs.reserve(front.size());
  for (const std::size_t i : front) costs.push_back(scores[i].costs);
  return costs;
}

/// Of costs in lexicographic order, whether an earlier one dominates a later one: it is less somewhere
/// already.
bool isNowhereGreater(const std::vector<double>& earlier, const std::vector<double>& later) {
  for (std::size_t i = 0; i < earlier.size(); ++i)
    if (earlier[i] > later[i]) return false;
  return true;
}

/// The fronts of feasible scores, by Pareto dominance. In lexicographic order none is dominated by a later
/// one, so each belongs into the first front that has nobody who dominates it (efficient non-dominated sort,
/// [Zhang2015]).
std::vector<Front> feasibleFrontsOf(const std::vector<Score>& scores) {
  Front feasible = feasibleOf(scores);
  std::stable_sort(feasible.begin(), feasible.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a].costs < scores[b].costs; });
  std::vector<Front> fronts;
  for (const std::size_t i : feasible) {
    const auto isDominatedIn = [&](const Front& front) {
      return std::any_of(front.rbegin(), front.rend(), [&](std::size_t other) {
        return isNowhereGreater(scores[other].costs, scores[i].costs) &&
               scores[other].costs != scores[i].costs;
      });
    };
    const auto own = std::find_if_not(fronts.begin(), fronts.end(), isDominatedIn);
    own == fronts.end() ? fronts.push_back({i}) : own->push_back(i);
  }
  for (Front& front : fronts) std::sort(front.begin(), front.end());
  return fronts;
}

bool isConstant(const Costs& costs, std::size_t column) {
  return std::all_of(costs.begin(), costs.end(),
                     [&](const auto& row) { return row[column] == costs[0][column]; });
}

/// Without the columns that are the same in all rows: pagmo divides by their extent.
Costs withoutConstants(const Costs& costs) {
  Costs varying(costs.size());
  for (std::size_t column = 0; column < costs[0].size(); ++column) {
    if (isConstant(costs, column)) continue;
    for (std::size_t row = 0; row < costs.size(); ++row) varying[row].push_back(costs[row][column]);
  }
  return varying;
}

std::vector<double> crowdingOfVarying(const Costs& costs) {
  // pagmo takes no single cost; a second one that is its opposite has the same neighbours and extents.
  if (costs[0].size() > 1) return pagmo::crowding_distance(costs);
  Costs doubled = costs;
  for (auto& row : doubled) row.push_back(-row[0]);
  return pagmo::crowding_distance(doubled);
}

}  // namespace

Score scoreOf(const Goals& goals, const std::vector<std::string>& response_names,
              const Evaluation& evaluation) {
  if (!isEvaluated(evaluation)) return {};
  return {lamina::costsOf(goals, response_names, evaluation.responses),
          violationOf(goals, response_names, evaluation.responses)};
}

std::vector<Front> frontsOf(const std::vector<Score>& scores) {
  std::vector<Front> fronts = feasibleFrontsOf(scores);
  std::map<double, Front> infeasible;
  Front untried;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!isScored(scores[i])) untried.push_back(i);
    if (isScored(scores[i]) && !isFeasible(scores[i])) infeasible[scores[i].violation].push_back(i);
  }
  for (auto& [violation, front] : infeasible) fronts.push_back(std::move(front));
  if (!untried.empty()) fronts.push_back(std::move(untried));
  return fronts;
}

Front paretoFront(const std::vector<Score>& scores) {
  const std::vector<Front> fronts = feasibleFrontsOf(scores);
  return fronts.empty() ? Front{} : fronts.front();
}

std::vector<double> crowdingOf(const std::vector<Score>& scores, const Front& front) {
  std::vector<double> nothing(front.size(), 0.0);
  if (front.empty() || !isScored(scores[front[0]])) return nothing;
  if (front.size() == 1) return {kInfinity};
  const Costs varying = withoutConstants(costsOf(scores, front));
  return varying[0].empty() ? nothing : crowdingOfVarying(varying);
}

double hypervolume(const std::vector<std::vector<double>>& costs, const std::vector<double>& reference) {
  Costs better;
  for (const auto& point : costs)
    if (std::equal(point.begin(), point.end(), reference.begin(), reference.end(), std::less<>()))
      better.push_back(point);
  if (better.empty()) return 0.0;
  if (reference.size() > 1) return pagmo::hypervolume(better).compute(reference);
  return reference[0] - (*std::min_element(better.begin(), better.end()))[0];
}

}  // namespace lamina
