// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// Costs and violation of a point, by which searches compare points.
struct Score {
  std::vector<double> costs;  ///< less is better; empty if the point could not be tried
  double violation = 0.0;     ///< of all constraints; 0 if they are met
};

/// Whether the point could be tried.
inline bool isScored(const Score& score) { return !score.costs.empty(); }
/// Whether the point could be tried and meets all constraints.
inline bool isFeasible(const Score& score) { return isScored(score) && score.violation == 0.0; }

/// The score of an evaluation; without costs if it failed.
Score scoreOf(const Goals& goals, const std::vector<std::string>& response_names,
              const Evaluation& evaluation);

/// Indices of scores of which none is better than another.
using Front = std::vector<std::size_t>;

/// All scores in fronts, the best one first, by constraint-dominance [Deb2002]: feasible scores by Pareto
/// dominance; after them infeasible scores by increasing violation, equal violations in one front; last, in
/// one front, scores of points that could not be tried. No front is empty.
std::vector<Front> frontsOf(const std::vector<Score>& scores);

/// The feasible scores that no other feasible one dominates, in order; empty if none is feasible. Of equal
/// scores, all are in it.
Front paretoFront(const std::vector<Score>& scores);

/// Crowding distance of each score of a front [Deb2002]: the extent of the box between its neighbours, each
/// cost relative to its extent in the front; infinite for the least and the greatest of a cost. A cost that
/// is the same everywhere has no influence. The distance is 0 if all costs are the same everywhere, and for
/// scores of points that could not be tried.
std::vector<double> crowdingOf(const std::vector<Score>& scores, const Front& front);

/// The volume of cost space that the points dominate, bounded by the reference: larger is better. Points that
/// are not better than the reference in all costs add nothing.
double hypervolume(const std::vector<std::vector<double>>& costs, const std::vector<double>& reference);

}  // namespace lamina
