// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/student_t.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

// Measured on printed parts: roughness and fracture load [Sobreviela2014, tables 6.1 and 6.2].
const Sample kRoughBefore{5.88, 1.31, 18};
const Sample kRoughAfter{4.64, 1.13, 15};
const Sample kLoadBefore{0.69, 0.03, 9};
const Sample kLoadAfter{0.74, 0.05, 8};

TEST(StudentTest, OfTheRoughnessIsThatOfTheSource) {
  EXPECT_NEAR(kRoughAfter.mean / kRoughBefore.mean - 1.0, -0.2109, 5e-5);
  const StudentTest test = compareMeans(kRoughBefore, kRoughAfter);
  EXPECT_NEAR(test.t, (5.88 - 4.64) / std::sqrt(1.31 * 1.31 / 18.0 + 1.13 * 1.13 / 15.0), 1e-12);
  // Printed from means that were not yet rounded to 0.01, which moves it by 0.024 at most.
  EXPECT_NEAR(test.t, 2.93, 0.024);
  EXPECT_EQ(test.degrees_of_freedom, 31U);
  EXPECT_LT(test.probability, 0.005);
}

TEST(StudentTest, OfTheLoadIsThatOfTheRoundedMeans) {
  EXPECT_NEAR(kLoadAfter.mean / kLoadBefore.mean - 1.0, 0.0725, 5e-5);
  const StudentTest test = compareMeans(kLoadAfter, kLoadBefore);
  EXPECT_NEAR(test.t, (0.74 - 0.69) / std::sqrt(0.03 * 0.03 / 9.0 + 0.05 * 0.05 / 8.0), 1e-12);
  EXPECT_EQ(test.degrees_of_freedom, 15U);
}

/// The value of t where the second mean is that of the first and a difference, with both deviations.
double tOf(double difference, double first_deviation, double second_deviation) {
  return compareMeans({kLoadBefore.mean + difference, second_deviation, kLoadAfter.count},
                      {kLoadBefore.mean, first_deviation, kLoadBefore.count})
      .t;
}

TEST(StudentTest, OfTheLoadLeavesRoomForThePrintedValue) {
  // Means and deviations are rounded to 0.01: the printed 2.87 lies in what they may have been.
  EXPECT_LT(tOf(0.04, 0.035, 0.055), 2.87);
  EXPECT_GT(tOf(0.06, 0.025, 0.045), 2.87);
}

TEST(StudentTest, HasTheProbabilitiesAndCriticalValuesOfTheTable) {
  EXPECT_NEAR(probabilityAbove(2.93, 31), 0.00316, 5e-6);
  EXPECT_NEAR(probabilityAbove(2.87, 15), 0.0058, 5e-5);
  EXPECT_NEAR(criticalT(0.995, 31), 2.744, 5e-4);
  EXPECT_NEAR(criticalT(0.99, 15), 2.602, 5e-4);
}

TEST(StudentTest, RefusesSamplesThatReportNothing) {
  EXPECT_THROW(compareMeans({1.0, 0.1, 1}, {2.0, 0.1, 5}), InvalidInput);
  EXPECT_THROW(compareMeans({1.0, 0.0, 5}, {2.0, 0.0, 5}), InvalidInput);
  EXPECT_THROW(criticalT(1.0, 5), InvalidInput);
  EXPECT_THROW(probabilityAbove(1.0, 0), InvalidInput);
}

}  // namespace
}  // namespace lamina
