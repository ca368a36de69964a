// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lamina {
namespace {

constexpr int kCount = 100000;

TEST(Random, GivesTheNumbersOfSplitMix64) {
  // The reference implementation's first numbers for seed 1234567.
  Random random(1234567);
  EXPECT_EQ(random.bits(), 6457827717110365317ULL);
  EXPECT_EQ(random.bits(), 3203168211198807973ULL);
  EXPECT_EQ(random.bits(), 9817491932198370423ULL);
}

TEST(Random, UniformStaysInsideAndHasTheRightMean) {
  Random random(1);
  double sum = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.uniform(-2.0, 6.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 6.0);
    sum += value;
  }
  // Five standard errors of the mean.
  EXPECT_NEAR(sum / kCount, 2.0, 5 * 8.0 / std::sqrt(12.0 * kCount));
}

TEST(Random, BelowReachesEveryNumberAboutEquallyOften) {
  Random random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < kCount; ++i) ++counts.at(random.below(7));
  for (const int count : counts) EXPECT_NEAR(count, kCount / 7.0, 5 * std::sqrt(kCount / 7.0));
}

TEST(Random, NormalHasTheRightMeanAndDeviation) {
  Random random(3);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.normal(10.0, 2.0);
    ASSERT_TRUE(std::isfinite(value));
    sum += value;
    squares += (value - 10.0) * (value - 10.0);
  }
  EXPECT_NEAR(sum / kCount, 10.0, 5 * 2.0 / std::sqrt(kCount));
  EXPECT_NEAR(std::sqrt(squares / kCount), 2.0, 0.05);
}

}  // namespace
}  // namespace lamina
