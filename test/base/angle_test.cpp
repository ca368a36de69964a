// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/angle.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Angle, IsWrappedIntoATurnThatEndsAtItsUpperBound) {
  EXPECT_EQ(wrappedDegrees(180.0), 180.0);
  EXPECT_EQ(wrappedDegrees(-180.0), 180.0);
  EXPECT_EQ(wrappedDegrees(540.0), 180.0);
  EXPECT_EQ(wrappedDegrees(-170.0), -170.0);
  EXPECT_EQ(wrappedDegrees(350.0), -10.0);
  EXPECT_EQ(wrappedDegrees(-730.0), -10.0);
  EXPECT_EQ(wrappedRadians(M_PI), M_PI);
  EXPECT_EQ(wrappedRadians(-M_PI), M_PI);
  EXPECT_NEAR(wrappedRadians(7.0), 7.0 - 2.0 * M_PI, 1e-15);
  EXPECT_NEAR(wrappedRadians(-4.0), 2.0 * M_PI - 4.0, 1e-15);
}

}  // namespace
}  // namespace lamina
