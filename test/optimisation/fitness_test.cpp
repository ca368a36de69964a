// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/fitness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const std::vector<std::string> kFitnessNames = {"modulus_mpa", "mass_g", "time_s"};

std::vector<Evaluation> design() {
  return {{{1.0}, {1000.0, 2.0, 50.0}, ""},
          {{2.0}, {3000.0, 4.0, NAN}, ""},
          {{3.0}, {}, "cannot be sliced"},
          {{2.0}, {3000.0, 8.0, NAN}, ""}};
}

TEST(FitnessTest, WeighsResponsesRelativeToTheirMeansOverPoints) {
  const Goals goals{{{"mass_g", Sense::Minimise, 0.5}, {"modulus_mpa", Sense::Maximise, 0.25}}, {}};
  const Fitness fitness(goals, kFitnessNames, design());
  EXPECT_EQ(fitness.sense(), Sense::Minimise);
  // Means: 2 and (4 + 8) / 2 give 4; 1000 and 3000 give 2000.
  EXPECT_DOUBLE_EQ(fitness.valueOf({1000.0, 3.0, 0.0}), 0.5 * 3.0 / 4.0 - 0.25 * 0.5);
  EXPECT_DOUBLE_EQ(fitness.costOf({1000.0, 3.0, 0.0}), fitness.valueOf({1000.0, 3.0, 0.0}));
}

TEST(FitnessTest, TakesItsSenseFromTheFirstObjectiveThatCounts) {
  const Goals goals{{{"time_s", Sense::Minimise, 0.0}, {"modulus_mpa", Sense::Maximise, 1.0}}, {}};
  const Fitness fitness(goals, kFitnessNames, design());
  EXPECT_EQ(fitness.sense(), Sense::Maximise);
  EXPECT_DOUBLE_EQ(fitness.valueOf({1000.0, 0.0, NAN}), 0.5);
  EXPECT_DOUBLE_EQ(fitness.costOf({1000.0, 0.0, NAN}), -0.5);
}

TEST(FitnessTest, AddsVariancesOfIndependentPredictions) {
  const Goals goals{{{"mass_g", Sense::Minimise, 0.5}, {"modulus_mpa", Sense::Maximise, 0.25}}, {}};
  const Prediction cost =
      Fitness(goals, kFitnessNames, design()).predictedCost({{1000.0, 1e4}, {3.0, 0.04}, {0.0, 99.0}});
  EXPECT_DOUBLE_EQ(cost.value, 0.5 * 3.0 / 4.0 - 0.25 * 0.5);
  EXPECT_DOUBLE_EQ(cost.variance, 0.125 * 0.125 * 0.04 + 0.000125 * 0.000125 * 1e4);
}

TEST(FitnessTest, RefusesWeightsThatMeanNothing) {
  EXPECT_THROW(Fitness({{{"mass_g", Sense::Minimise, 0.0}}, {}}, kFitnessNames, design()), InvalidConfig);
  EXPECT_THROW(Fitness({{{"mass_g", Sense::Minimise, 1.0}}, {}}, kFitnessNames, {}), InvalidInput);
  const std::vector<Evaluation> balanced = {{{1.0}, {-1.0, 0.0, 0.0}, ""}, {{2.0}, {1.0, 0.0, 0.0}, ""}};
  EXPECT_THROW(Fitness({{{"modulus_mpa", Sense::Minimise, 1.0}}, {}}, kFitnessNames, balanced), InvalidInput);
}

TEST(FitnessTest, BestSampleKeepsToItsIntervalsAndLacksNothing) {
  const Goals goals{{{"mass_g", Sense::Minimise, 1.0}}, {{"modulus_mpa", 1500.0, 1e9}}};
  const Fitness fitness(goals, kFitnessNames, design());
  EXPECT_EQ(bestFeasible(design(), goals, kFitnessNames, fitness), 1U);
  EXPECT_FALSE(bestFeasible({design()[0], design()[2]}, goals, kFitnessNames, fitness));
  const Goals timed{{{"mass_g", Sense::Minimise, 1.0}}, {{"time_s", 0.0, 1e9}}};
  EXPECT_EQ(bestFeasible(design(), timed, kFitnessNames, fitness), 0U);
}

TEST(FitnessTest, ReplicatesAreOnePointAtTheirMean) {
  const std::vector<Evaluation> unique = withoutReplicates(design());
  ASSERT_EQ(unique.size(), 2U);
  EXPECT_EQ(unique[1].point, (DesignPoint{2.0}));
  EXPECT_EQ(unique[1].responses[1], 6.0);
  EXPECT_TRUE(std::isnan(unique[1].responses[2]));
  EXPECT_TRUE(withoutReplicates({{{1.0}, {NAN, NAN, NAN}, ""}}).empty());
}

TEST(PredictionErrorTest, CountsConstraintsAndWeightsOnly) {
  const Goals goals{{{"mass_g", Sense::Minimise, 1.0}, {"time_s", Sense::Minimise, 0.0}},
                    {{"modulus_mpa", 0.0, 1e9}}};
  const auto error = [&](const std::vector<double>& measured, double modulus, double mass) {
    return predictionErrorPercent(goals, kFitnessNames, measured, {{modulus, 0.0}, {mass, 0.0}, {1e6, 0.0}});
  };
  EXPECT_DOUBLE_EQ(error({1000.0, 4.0, 1.0}, 1100.0, 3.0), (10.0 + 25.0) / 2.0);
  EXPECT_DOUBLE_EQ(error({0.0, 4.0, 1.0}, 0.0, 3.0), 12.5);
  EXPECT_TRUE(std::isinf(error({0.0, 4.0, 1.0}, 1.0, 4.0)));
  EXPECT_TRUE(std::isinf(error({1000.0, NAN, 1.0}, 1000.0, 4.0)));
}

}  // namespace
}  // namespace lamina
