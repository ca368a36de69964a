// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "stiffness/matrix_free_operator.hpp"

namespace lamina {

/// Elements, and which displacements of their nodes are prescribed.
struct ElasticProblem {
  ElasticElements elements;
  GivenNodes given;
};

/// When the iteration stops.
struct IterationLimits {
  double residual = 1e-6;  ///< greatest norm of the unbalanced forces, relative to that at the start
  int iterations = 500;
};

/// Outcome of the iteration.
struct Iteration {
  int count = 0;
  double residual = 0.0;  ///< relative residual reached, as in IterationLimits
};

/// Solves for the displacements that are not prescribed, so that forces balance: conjugate gradients with
/// multigrid as preconditioner, in double precision.
/// @param displacement  in: prescribed displacements, and start values of the others; out: the solution
/// @return the residual reached, which may be above the limit
/// @throws Cancelled
Iteration balance(const ElasticProblem& problem, const IterationLimits& limits,
                  NodeField<double>& displacement, Progress& progress);

}  // namespace lamina
