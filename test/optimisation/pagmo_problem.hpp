// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <pagmo/problem.hpp>
#include <string>
#include <vector>

#include "lamina/optimisation/search_problem.hpp"

namespace lamina {

/// A test problem of pagmo as a search of ours: the same bounds, all objectives minimised.
class PagmoProblem {
 public:
  explicit PagmoProblem(const pagmo::problem& problem) {
    const auto [low, high] = problem.get_bounds();
    for (std::size_t i = 0; i < low.size(); ++i)
      space_.push_back({"x" + std::to_string(i), VariableKind::Continuous, low[i], high[i], {}, {}});
    std::vector<std::string> names;
    for (std::size_t i = 0; i < problem.get_nobj(); ++i) {
      names.push_back("f" + std::to_string(i));
      goals_.objectives.push_back({names.back(), Sense::Minimise, 1.0});
    }
    evaluator_ = std::make_unique<ParallelEvaluator>(
        names, [problem](const DesignPoint& point, Progress&) { return problem.fitness(point); });
  }

  SearchProblem search() const { return {space_, goals_, *evaluator_}; }

 private:
  DesignSpace space_;
  Goals goals_;
  std::unique_ptr<ParallelEvaluator> evaluator_;
};

}  // namespace lamina
