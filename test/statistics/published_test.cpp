// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lamina/statistics/analysis_of_variance.hpp"
#include "lamina/statistics/kolmogorov_smirnov.hpp"
#include "lamina/statistics/kruskal_wallis.hpp"
#include "statistics/bending_moduli.hpp"

namespace lamina {
namespace {

constexpr double kFourDigits = 5e-5;
const std::vector<double> kMeasured{.0003, 0.0, 0.0, .1041, .7762, 0.0};

struct Design {
  std::vector<double> response;
  std::vector<Factor> factors{{"layer", {}}, {"infill", {}}, {"perimeters", {}}};

  void add(const BendingModuli& row, double value) {
    response.push_back(value);
    factors[0].levels.push_back(row.layer);
    factors[1].levels.push_back(row.infill);
    factors[2].levels.push_back(row.perimeters);
  }
};

Design measured() {
  Design design;
  for (const BendingModuli& row : bendingModuli())
    for (const double value : row.measured_mpa) design.add(row, value);
  return design;
}

Design simulated() {
  Design design;
  for (const BendingModuli& row : bendingModuli()) design.add(row, row.simulated_mpa);
  return design;
}

KolmogorovSmirnov againstItself(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return testNormality(values, mean, std::sqrt(squares / (n - 1.0)));
}

TEST(PublishedStatisticsTest, RanksOfTheMeasuredModuli) {
  std::vector<std::vector<double>> groups;
  for (const BendingModuli& row : bendingModuli()) groups.push_back(row.measured_mpa);
  const KruskalWallis test = testRanks(groups);
  EXPECT_NEAR(test.h, 72.603, 5e-4);
  EXPECT_NEAR(test.probability, 1.5296e-9, 5e-14);
  EXPECT_EQ(test.comparisons.size(), 120U);
}

void expectProbabilities(const Design& design, const std::vector<double>& published, double tolerance) {
  const AnalysisOfVariance analysis = analyseVariance(design.response, design.factors);
  ASSERT_EQ(analysis.sources.size(), published.size());
  for (std::size_t s = 0; s < published.size(); ++s)
    EXPECT_NEAR(analysis.sources[s].probability, published[s], tolerance) << analysis.sources[s].name;
}

TEST(PublishedStatisticsTest, VarianceOfTheMeasuredModuli) {
  // Five values with the published mean and deviation of each cell, which have a digit more than the values.
  Design design;
  for (const BendingModuli& row : bendingModuli())
    for (const double step : {-1.0, -0.5, 0.0, 0.5, 1.0})
      design.add(row, row.mean_mpa + row.deviation_mpa * step / std::sqrt(0.625));
  expectProbabilities(design, kMeasured, kFourDigits);
}

TEST(PublishedStatisticsTest, VarianceOfTheMeasuredModuliAsRounded) {
  // Random errors of up to 0.05 MPa move two of these by up to 0.0003 and 0.0009 in a thousand trials.
  expectProbabilities(measured(), kMeasured, 4e-4);
}

TEST(PublishedStatisticsTest, VarianceOfTheSimulatedModuli) {
  // The first is 0.014249 of the rounded moduli.
  expectProbabilities(simulated(), {.0143, .0089, .0008, .1820, .0506, .0167}, 5.2e-5);
  EXPECT_EQ(analyseVariance(simulated().response, simulated().factors).residual_degrees_of_freedom, 3U);
}

TEST(PublishedStatisticsTest, NormalityOfTheModuli) {
  EXPECT_NEAR(againstItself(measured().response).probability, .0029, kFourDigits);
  EXPECT_GT(againstItself(simulated().response).probability, 0.05);
  EXPECT_LT(testNormality(measured().response, 0.0, 1.0).probability, 1e-10);
}

}  // namespace
}  // namespace lamina
