// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/cell_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kSigma = 0.02;  // mm

TEST(CellEstimate, LayingAddsWhatIsPlannedLessWhatTheGainExpects) {
  CellEstimate cell(0.1, 0.05, 0.8);
  cell.lay({1.5, 0.25, 0.0}, 0.1);
  EXPECT_NEAR(cell.error(), 0.1 + 1.5 - 0.8 * 1.5 * 1.25, 1e-4);
  EXPECT_NEAR(cell.variance(), 0.05 * 0.05 + 0.15 * 0.15, 1e-4);
}

TEST(CellEstimate, OfAPressedProcessIsTheNozzlesPlane) {
  CellEstimate cell(0.7, 0.05, 1.0);
  cell.press({0.2, 0.1, 0.03}, 0.1);
  EXPECT_NEAR(cell.error(), 0.03, 1e-7);
  EXPECT_NEAR(cell.variance(), 0.02 * 0.02, 1e-9);
}

TEST(CellEstimate, WeighsAReadingByTheVariances) {
  CellEstimate cell(0.0, 0.1, 1.0);
  const ReadingOutcome outcome = cell.see({0.09, 1, 0.1}, 0.2);
  EXPECT_EQ(outcome.use, ReadingUse::Used);
  EXPECT_NEAR(outcome.surprise, 0.09 * 0.09 / 0.02, 1e-6);
  EXPECT_NEAR(cell.error(), 0.045, 1e-6);
  EXPECT_NEAR(cell.variance(), 0.005, 1e-7);
  EXPECT_TRUE(cell.isSeen());
}

TEST(CellEstimate, PointsThatCorrelateTellLess) {
  EXPECT_NEAR(readingVariance({0.0, 6, kSigma}, 0.2), kSigma * kSigma * 2.0 / 6.0, 1e-12);
  EXPECT_NEAR(readingVariance({0.0, 6, kSigma}, 1.0), kSigma * kSigma, 1e-12);
}

/// The mean absolute error of a Gaussian is 0.8 of its standard deviation: figures for n points of
/// correlation r, nothing known before.
TEST(CellEstimate, IsAsGoodAsThePointsAllow) {
  struct Case {
    int points;
    double correlation;
    double mae;
  };
  for (const Case& c : {Case{2, 0.0, 0.57}, Case{3, 0.0, 0.46}, Case{4, 0.1, 0.46}, Case{6, 0.2, 0.46}}) {
    Random random(7);
    double sum = 0.0;
    constexpr int kCells = 20000;
    for (int i = 0; i < kCells; ++i) {
      CellEstimate cell(0.0, 0.5, 1.0);
      const double truth = random.normal(0.0, 0.1);
      double mean = random.normal(0.0, kSigma * std::sqrt(c.correlation));
      for (int p = 0; p < c.points; ++p)
        mean += random.normal(0.0, kSigma * std::sqrt(1.0 - c.correlation)) / c.points;
      cell.see({truth + mean, c.points, kSigma}, c.correlation);
      sum += std::abs(cell.error() - truth) / kCells;
    }
    EXPECT_NEAR(sum / kSigma, c.mae, 0.01) << c.points << " points";
  }
}

TEST(CellEstimate, ContestsAStrayReading) {
  CellEstimate cell(0.0, 0.05, 1.0);
  EXPECT_EQ(cell.see({1.0, 6, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.error(), 0.0);
  EXPECT_FALSE(cell.isSeen());
  EXPECT_NEAR(cell.contested().value(), 1.0, 1e-6);
}

TEST(CellEstimate, BelievesThreeProfilesThatAgree) {
  CellEstimate cell(0.0, 0.05, 1.0);
  EXPECT_EQ(cell.see({1.00, 6, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.see({1.03, 6, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.see({0.99, 6, kSigma}, 0.2).use, ReadingUse::Believed);
  EXPECT_NEAR(cell.error(), 0.99, 1e-6);
  EXPECT_NEAR(cell.variance(), CellEstimate::kStartSigma * CellEstimate::kStartSigma, 1e-7);
}

TEST(CellEstimate, DoesNotBelieveProfilesThatDisagree) {
  CellEstimate cell(0.0, 0.05, 1.0);
  for (const double error : {1.0, -1.0, 2.0, 0.5, 3.0})
    EXPECT_EQ(cell.see({error, 6, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.error(), 0.0);
}

TEST(CellEstimate, TakesNoNumberThatIsNone) {
  CellEstimate cell(0.0, 0.05, 1.0);
  const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity()};
  for (const double error : bad) EXPECT_EQ(cell.see({error, 6, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.see({0.01, 0, kSigma}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.see({0.01, 6, 0.0}, 0.2).use, ReadingUse::Contested);
  EXPECT_EQ(cell.error(), 0.0);
  EXPECT_FALSE(cell.contested());
}

TEST(CellEstimate, MeasuresGrowthOverWhatWasCommanded) {
  CellEstimate cell(0.0, 1e-6, 1.0);
  cell.lay({1.5, 0.0, 0.0}, 0.1);
  cell.lay({1.5, 0.2, 0.0}, 0.1);
  cell.see({3.0 - 0.9 * (1.5 + 1.8), 1000, 1e-4}, 0.0);
  EXPECT_NEAR(cell.takeMeasuredGain().value().gain, 0.9, 1e-3);
  EXPECT_FALSE(cell.takeMeasuredGain()) << "nothing was deposited since";
}

/// A bead that is laid over air sags by what it lies on: how much of that is growth nobody can tell.
TEST(CellEstimate, MeasuresNoGrowthOverGroundThatIsNotKnown) {
  CellEstimate cell;
  cell.lay({1.5, 0.0, 0.0}, 0.1);
  EXPECT_EQ(cell.see({0.6, 6, kSigma}, 0.2).use, ReadingUse::Used);
  EXPECT_NEAR(cell.error(), 0.6, 1e-3);
  EXPECT_FALSE(cell.takeMeasuredGain());
  cell.lay({1.5, 0.0, 0.0}, 0.1);
  cell.see({0.75, 1000, 1e-4}, 0.0);
  EXPECT_NEAR(cell.takeMeasuredGain().value().gain, 0.9, 1e-3) << "from there on";
}

TEST(CellEstimate, LearnsNothingFromWhatBrokeOff) {
  CellEstimate cell(0.0, 0.05, 1.0);
  cell.lay({1.5, 0.0, 0.0}, 0.1);
  for (int i = 0; i < 3; ++i) cell.see({20.0, 6, kSigma}, 0.2);
  EXPECT_NEAR(cell.error(), 20.0, 1e-5);
  EXPECT_FALSE(cell.takeMeasuredGain());
}

TEST(CellEstimate, KeepsItsGainWithinLimits) {
  CellEstimate cell(0.0, 0.05, 9.0);
  EXPECT_NEAR(cell.gain(), 2.5, 1e-4);
  cell.setGain(0.1);
  EXPECT_NEAR(cell.gain(), 0.4, 1e-4);
}

}  // namespace
}  // namespace lamina
