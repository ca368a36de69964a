// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/time_left.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(TimeLeft, GoesOnAsFastAsSoFar) {
  TimeLeft left;
  left.begin(0.5, 1000.0);
  EXPECT_FALSE(left.at(0.504, 1010.0)) << "too little was seen";
  ASSERT_TRUE(left.at(0.6, 1100.0));
  EXPECT_NEAR(*left.at(0.6, 1100.0), 400.0, 1e-9) << "a tenth in 100 s, four tenths are left";
  EXPECT_EQ(left.at(1.0, 1500.0), 0.0);
}

}  // namespace
}  // namespace lamina
