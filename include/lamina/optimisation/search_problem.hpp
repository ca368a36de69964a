// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// What a search needs to know: which variables it may change, what is wanted, and how points are tried.
struct SearchProblem {
  DesignSpace space;
  Goals goals;
  Evaluator& evaluator;  ///< must outlive the problem
};

/// @throws InvalidConfig if the space or the goals cannot be used
void validate(const SearchProblem& problem);

}  // namespace lamina
