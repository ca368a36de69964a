// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/optimisation/goals.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// Expected value of max(0, best_cost - cost) for a normally distributed cost [Jones1998, eq. 15]. If the
/// cost has no variance, this is max(0, best_cost - cost.value).
double expectedImprovement(const Prediction& cost, double best_cost);

/// Probability that a normally distributed response lies in the interval of a constraint. If the response has
/// no variance, this is 0 or 1.
double probabilityWithin(const Constraint& constraint, const Prediction& prediction);

}  // namespace lamina
