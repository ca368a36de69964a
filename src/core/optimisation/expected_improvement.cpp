// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/expected_improvement.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

double normalDensity(double z) { return 0.3989422804014327 * std::exp(-0.5 * z * z); }

double normalProbabilityBelow(double z) { return 0.5 * std::erfc(-z * 0.7071067811865476); }

}  // namespace

double expectedImprovement(const Prediction& cost, double best_cost) {
  const double improvement = best_cost - cost.value;
  if (!(cost.variance > 0.0)) return std::max(0.0, improvement);
  const double deviation = std::sqrt(cost.variance);
  const double z = improvement / deviation;
  return std::max(0.0, improvement * normalProbabilityBelow(z) + deviation * normalDensity(z));
}

double probabilityWithin(const Constraint& constraint, const Prediction& prediction) {
  if (!(prediction.variance > 0.0))
    return prediction.value >= constraint.low && prediction.value <= constraint.high ? 1.0 : 0.0;
  const double deviation = std::sqrt(prediction.variance);
  return normalProbabilityBelow((constraint.high - prediction.value) / deviation) -
         normalProbabilityBelow((constraint.low - prediction.value) / deviation);
}

}  // namespace lamina
