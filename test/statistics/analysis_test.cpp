// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/statistics/analysis_of_variance.hpp"
#include "lamina/statistics/kolmogorov_smirnov.hpp"
#include "lamina/statistics/kruskal_wallis.hpp"

namespace lamina {
namespace {

TEST(KolmogorovSmirnovTest, OneValueLiesAsFarAsTheUniformDistributionSays) {
  // At the median D is 1/2, which no value can undercut; at probability p < 1/2, P(D >= 1 - p) = 2 p.
  EXPECT_NEAR(testNormality({0.0}, 0.0, 1.0).probability, 1.0, 1e-12);
  const double tenth = -1.2815515655446004;
  EXPECT_NEAR(testNormality({tenth}, 0.0, 1.0).probability, 0.2, 1e-9);
}

TEST(KolmogorovSmirnovTest, IsWhatMarsagliaTsangAndWangGive) {
  // [Marsaglia2003]: K(10, 0.274) = 0.6284796154565. Values at the quantiles (i - 1/2)/10 + 0.274 - 1/20 lie
  // so far.
  const auto quantile = [](double p) {
    double low = -10.0;
    double high = 10.0;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
    }
    return low;
  };
  std::vector<double> values;
  for (int i = 0; i < 10; ++i) values.push_back(quantile(std::min(0.9999, i / 10.0 + 0.274)));
  const KolmogorovSmirnov test = testNormality(values, 0.0, 1.0);
  EXPECT_NEAR(test.distance, 0.274, 1e-9);
  EXPECT_NEAR(test.probability, 1.0 - 0.6284796154565, 1e-8);
}

TEST(KolmogorovSmirnovTest, RefusesWhatHasNoSpread) {
  EXPECT_THROW(testNormality({}, 0.0, 1.0), InvalidInput);
  EXPECT_THROW(testNormality({1.0}, 0.0, 0.0), InvalidInput);
  EXPECT_THROW(testNormality({std::nan("")}, 0.0, 1.0), InvalidInput);
}

TEST(KruskalWallisTest, OfTwoGroupsApartIsWhatTheirRanksSay) {
  // Ranks 1 2 3 and 4 5 6: H = 12 / (6 7) (3 1.5² + 3 1.5²) = 27/7.
  const KruskalWallis test = testRanks({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
  EXPECT_NEAR(test.h, 27.0 / 7.0, 1e-12);
  EXPECT_NEAR(test.probability, std::erfc(std::sqrt(27.0 / 14.0)), 1e-12);
  // Of two groups the range is the difference itself: the same probability.
  EXPECT_NEAR(test.comparisons.at(0).probability, test.probability, 1e-9);
  EXPECT_NEAR(test.comparisons.at(0).difference, -3.0, 1e-12);
}

TEST(KruskalWallisTest, DependsOnTheOrderOfValuesOnly) {
  EXPECT_TRUE(rc::check([] {
    std::vector<std::vector<double>> groups(3);
    for (auto& group : groups) {
      const int count = *rc::gen::inRange(1, 8);
      for (int i = 0; i < count; ++i) group.push_back(*rc::gen::inRange(-9, 10));
    }
    groups[0].push_back(11.0);
    auto warped = groups;
    for (auto& group : warped)
      for (double& value : group) value = value * value * value + 5.0;
    RC_ASSERT(std::abs(testRanks(groups).h - testRanks(warped).h) < 1e-9);
  }));
}

TEST(KruskalWallisTest, RangesHaveTheirTabulatedPoints) {
  EXPECT_NEAR(probabilityOfRangeAbove(3.314, 3), 0.05, 1e-4);
  EXPECT_NEAR(probabilityOfRangeAbove(4.474, 10), 0.05, 1e-4);
  EXPECT_NEAR(probabilityOfRangeAbove(4.120, 3), 0.01, 1e-4);
}

TEST(KruskalWallisTest, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(testRanks({{1.0}}), InvalidInput);
  EXPECT_THROW(testRanks({{1.0}, {}}), InvalidInput);
  EXPECT_THROW(testRanks({{1.0, 1.0}, {1.0}}), InvalidInput);
}

TEST(AnalysisOfVarianceTest, OfOneFactorSplitsTheSquares) {
  // Means 2 and 5 about 3.5: 3 2.25 twice between, 2 twice within; F = 13.5 / (4 / 4).
  const AnalysisOfVariance analysis =
      analyseVariance({1, 2, 3, 4, 5, 6}, {{"kind", {"a", "a", "a", "b", "b", "b"}}});
  EXPECT_NEAR(analysis.sources[0].sum_of_squares, 13.5, 1e-12);
  EXPECT_NEAR(analysis.residual_sum_of_squares, 4.0, 1e-12);
  EXPECT_NEAR(analysis.sources[0].f, 13.5, 1e-12);
}

TEST(AnalysisOfVarianceTest, OfUnequalCellsIsTypeIII) {
  // Type III tests the unweighted means of the cells: 1/4 of (1 + 5) - (2 + 8) on the error of that contrast.
  const std::vector<double> y{0, 2, 5, 5, 5, 1, 3, 8, 7, 9};
  const Factor a{"a", {"1", "1", "1", "1", "1", "2", "2", "2", "2", "2"}};
  const Factor b{"b", {"1", "1", "2", "2", "2", "1", "1", "2", "2", "2"}};
  const AnalysisOfVariance equal = analyseVariance(y, {a, b});
  // Cell means 1, 5, 2, 8 with 2, 3, 2, 3 values: contrast (6 - 10)² / (1/2 + 1/3 + 1/2 + 1/3).
  EXPECT_NEAR(equal.sources[0].sum_of_squares, 16.0 / (5.0 / 3.0), 1e-9);
  EXPECT_NEAR(equal.sources[1].sum_of_squares, 100.0 / (5.0 / 3.0), 1e-9);
  EXPECT_NEAR(equal.sources[2].sum_of_squares, 4.0 / (5.0 / 3.0), 1e-9);
}

TEST(AnalysisOfVarianceTest, RefusesDesignsThatCannotTell) {
  EXPECT_THROW(analyseVariance({1, 2}, {}), InvalidInput);
  EXPECT_THROW(analyseVariance({1, 2}, {{"a", {"1", "1"}}}), InvalidInput);
  EXPECT_THROW(analyseVariance({1, 2}, {{"a", {"1", "2"}}}), InvalidInput);
  EXPECT_THROW(analyseVariance({1, 2, 3}, {{"a", {"1", "2"}}}), InvalidInput);
  // No observation of a = 2 with b = 2.
  EXPECT_THROW(analyseVariance({1, 2, 3, 4, 5, 6}, {{"a", {"1", "1", "1", "1", "2", "2"}},
                                                    {"b", {"1", "1", "2", "2", "1", "1"}}}),
               InvalidInput);
}

}  // namespace
}  // namespace lamina
