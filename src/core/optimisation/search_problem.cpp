// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/search_problem.hpp"

namespace lamina {

void validate(const SearchProblem& problem) {
  validate(problem.space);
  validate(problem.goals, problem.evaluator.responseNames());
}

}  // namespace lamina
