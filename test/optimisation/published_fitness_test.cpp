// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lamina/optimisation/fitness.hpp"
#include "optimisation/published_tables.hpp"

namespace lamina {
namespace {

std::vector<Prediction> predicted(const std::vector<double>& values) {
  std::vector<Prediction> predictions;
  for (const double value : values) predictions.push_back({value, 0.0});
  return predictions;
}

/// Rows that keep to the intervals, counted from 1 as in print.
std::vector<std::size_t> feasibleRows(const PublishedStudy& study) {
  const std::vector<Evaluation> design = study.table().design;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < design.size(); ++i)
    if (violationOf(study.goals, study.response_names, design[i].responses) == 0.0) rows.push_back(i + 1);
  return rows;
}

TEST(PublishedFitnessTest, ErrorOfThePublishedPredictions) {
  const PublishedStudy study = miniSpecimens();
  const std::vector<Evaluation> measured = study.table().proposed;
  ASSERT_EQ(measured.size(), 4U);
  const auto error = [&](std::size_t iteration, const std::vector<double>& prediction) {
    return predictionErrorPercent(study.goals, study.response_names, measured[iteration].responses,
                                  predicted(prediction));
  };
  EXPECT_NEAR(error(0, {2200.0, 0.364, 138.0, 2948.18}), 5.06, 0.02);  // from rounded predictions
  EXPECT_NEAR(error(2, {2200.73, 0.366, 122.0, 2710.4}), 2.45, 0.005);
  EXPECT_NEAR(error(3, {2200.09, 0.367, 122.0, 2707.67}), 0.93, 0.005);
}

TEST(PublishedFitnessTest, FeasibleScaffolds) {
  EXPECT_EQ(feasibleRows(sinusoidalScaffolds()),
            (std::vector<std::size_t>{1, 2, 3, 4, 5, 16, 25, 27, 30, 31, 32, 33, 36}));
  EXPECT_EQ(feasibleRows(mirroredScaffolds()), (std::vector<std::size_t>{4, 7, 8, 12}));
  EXPECT_EQ(feasibleRows(gyroidScaffolds()), (std::vector<std::size_t>{1, 2, 4}));
}

TEST(PublishedFitnessTest, FitnessOfTheSixPrintedScaffoldsAndTheBestOfEachKind) {
  const auto check = [](const PublishedStudy& study,
                        const std::vector<std::pair<std::size_t, double>>& printed, std::size_t best_row) {
    const std::vector<Evaluation> design = study.table().design;
    const Fitness fitness(study.goals, study.response_names, design);
    EXPECT_EQ(fitness.sense(), Sense::Maximise);
    for (const auto& [row, value] : printed)
      EXPECT_NEAR(fitness.valueOf(design[row - 1].responses), value, 0.005) << study.file << " row " << row;
    EXPECT_EQ(bestFeasible(design, study.goals, study.response_names, fitness), best_row - 1) << study.file;
  };
  check(sinusoidalScaffolds(), {{5, 1.15}, {27, 0.93}}, 5);
  check(mirroredScaffolds(), {{7, 1.23}, {4, 1.08}}, 7);
  check(gyroidScaffolds(), {{1, 1.20}, {4, 0.88}}, 1);
}

TEST(PublishedFitnessTest, MeasuredModuliAreThreeQuartersOfSimulatedOnes) {
  const ExperimentTable table = miniSpecimens().table();
  std::vector<double> factors;
  for (const auto* rows : {&table.design, &table.proposed})
    for (const Evaluation& row : *rows) factors.push_back(row.responses[0] / row.responses[3]);
  const auto n = static_cast<double>(factors.size());
  const double mean = std::accumulate(factors.begin(), factors.end(), 0.0) / n;
  double squares = 0.0;
  for (const double factor : factors) squares += (factor - mean) * (factor - mean);
  EXPECT_EQ(factors.size(), 20U);
  EXPECT_NEAR(mean, 0.732, 0.0005);
  EXPECT_NEAR(std::sqrt(squares / n), 0.058, 0.0005);
}

}  // namespace
}  // namespace lamina
