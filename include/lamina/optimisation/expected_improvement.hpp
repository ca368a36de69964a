// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/optimisation/goals.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// By how much a cost is expected to be less than the best known one [Jones1998, eq. 15].
/// Without variance, the improvement itself; never negative.
double expectedImprovement(const Prediction& cost, double best_cost);

/// Probability that a normally distributed response lies in an interval. Without variance, 0 or 1.
double probabilityWithin(const Constraint& constraint, const Prediction& prediction);

}  // namespace lamina
