// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/expected_improvement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

/// Mean of max(0, best - cost) over a normal distribution, by the trapezoidal rule.
double integratedImprovement(const Prediction& cost, double best) {
  const double deviation = std::sqrt(cost.variance);
  const double step = 1e-3;
  double sum = 0.0;
  for (double z = -9.0; z <= 9.0; z += step)
    sum += std::max(0.0, best - cost.value - deviation * z) * std::exp(-0.5 * z * z) * step;
  return sum / std::sqrt(2.0 * M_PI);
}

TEST(ExpectedImprovementTest, IsTheMeanGainOverTheBest) {
  for (const double value : {-1.0, 0.5, 1.0, 3.0})
    for (const double variance : {0.01, 1.0, 4.0})
      EXPECT_NEAR(expectedImprovement({value, variance}, 1.0), integratedImprovement({value, variance}, 1.0),
                  1e-6)
          << value << " " << variance;
}

TEST(ExpectedImprovementTest, WithoutVarianceItIsTheGainItself) {
  EXPECT_EQ(expectedImprovement({0.25, 0.0}, 1.0), 0.75);
  EXPECT_EQ(expectedImprovement({2.0, 0.0}, 1.0), 0.0);
  EXPECT_GE(expectedImprovement({90.0, 1.0}, 1.0), 0.0);
}

TEST(ProbabilityWithinTest, IsThatOfANormalDistribution) {
  EXPECT_NEAR(probabilityWithin({"r", -1.0, 1.0}, {0.0, 1.0}), 0.6826894921, 1e-9);
  EXPECT_NEAR(probabilityWithin({"r", 2200.0, INFINITY}, {2200.0, 100.0}), 0.5, 1e-12);
  EXPECT_NEAR(probabilityWithin({"r", -INFINITY, 3.0}, {0.0, 1.0}), 0.9986501020, 1e-9);
  EXPECT_EQ(probabilityWithin({"r", 1.0, 2.0}, {2.0, 0.0}), 1.0);
  EXPECT_EQ(probabilityWithin({"r", 1.0, 2.0}, {2.1, 0.0}), 0.0);
}

}  // namespace
}  // namespace lamina
