// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "stiffness/matrix_free_operator.hpp"

namespace lamina {

/// Elements and which displacements of their nodes are given.
struct ElasticProblem {
  ElasticElements elements;
  GivenNodes given;
};

/// When to stop.
struct IterationLimits {
  double residual = 1e-6;  ///< length of the unbalanced forces over that at the start
  int iterations = 500;
};

/// How it went.
struct Iteration {
  int count = 0;
  double residual = 0.0;  ///< as in IterationLimits, reached
};

/// Moves the nodes that are not given until forces balance, by conjugate gradients with the multigrid as
/// preconditioner, in double precision.
///
/// @param displacement  holds the given displacements; the others are where the search begins
/// @return what was reached, which may be short of the limit
/// @throws Cancelled
Iteration balance(const ElasticProblem& problem, const IterationLimits& limits,
                  NodeField<double>& displacement, Progress& progress);

}  // namespace lamina
