// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/lateness.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Lateness, CountsAndGivesPercentiles) {
  Lateness lateness;
  EXPECT_EQ(lateness.percentile(0.99), 0.0);
  for (int i = 0; i < 98; ++i) lateness.add(0.00042);
  lateness.add(0.02);
  lateness.add(0.3);
  EXPECT_EQ(lateness.count(), 100U);
  EXPECT_EQ(lateness.late(), 2U);
  EXPECT_EQ(lateness.tooLate(), 1U);
  EXPECT_EQ(lateness.worst(), 0.3);
  EXPECT_NEAR(lateness.percentile(0.5), 0.0005, 1e-12);
  EXPECT_NEAR(lateness.percentile(0.99), 0.0201, 1e-4);
  EXPECT_EQ(lateness.percentile(1.0), 0.3);
}

TEST(Lateness, EarlyIsNotLate) {
  Lateness lateness;
  lateness.add(-1.0);
  EXPECT_EQ(lateness.worst(), 0.0);
  EXPECT_EQ(lateness.percentile(1.0), 0.0);
}

}  // namespace
}  // namespace lamina
