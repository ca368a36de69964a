// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/time_left.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(TimeLeft, IsWhatTheRestTakesAtTheSameRate) {
  TimeLeft left;
  for (int second = 0; second <= 100; ++second) left.observe(second, 1, second / 1000.0);
  const auto estimate = left.estimate();
  ASSERT_TRUE(estimate);
  EXPECT_NEAR(estimate->seconds, 900.0, 1.0);
  EXPECT_NEAR(estimate->least_s, 792.0, 1.0);
  EXPECT_NEAR(estimate->most_s, 1008.0, 1.0);
}

TEST(TimeLeft, SpansTheRateOfAllAndOfTheLastMinutes) {
  TimeLeft left;
  double fraction = 0.0;
  for (int second = 0; second <= 1000; ++second) {
    left.observe(second, 1, fraction);
    fraction += second < 500 ? 0.0002 : 0.0004;  // twice as fast since the middle
  }
  const auto estimate = left.estimate();
  ASSERT_TRUE(estimate);
  EXPECT_NEAR(estimate->most_s, 1.1 * 0.7 / 0.0003, 20.0);
  EXPECT_NEAR(estimate->least_s, 0.9 * 0.7 / 0.0004, 20.0);
}

TEST(TimeLeft, DoesNotCountPausesAndBeginsAnewWithAnotherJob) {
  TimeLeft left;
  for (int second = 0; second <= 100; ++second) left.observe(second, 1, second / 1000.0);
  left.pause(5000.0);
  left.observe(5001.0, 1, 0.101);
  ASSERT_TRUE(left.estimate());
  EXPECT_NEAR(left.estimate()->seconds, 899.0, 10.0);
  left.observe(5002.0, 2, 0.0);
  EXPECT_FALSE(left.estimate());
}

}  // namespace
}  // namespace lamina
