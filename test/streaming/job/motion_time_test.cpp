// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/motion_time.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(MotionTime, IsLengthOverFeedOfEachCommand) {
  MotionTime time;
  EXPECT_DOUBLE_EQ(time.secondsOf("M104 S200"), 0.0);
  EXPECT_NEAR(time.secondsOf("G1 X30 Y40 F3000"), 1.0, 1e-12);  // 50 mm at 50 mm/s
  EXPECT_NEAR(time.secondsOf("G91"), 0.0, 1e-12);
  EXPECT_NEAR(time.secondsOf("G1 X-5"), 0.1, 1e-12);
}

TEST(MotionTime, SaysNothingBehindWhatItCannotRead) {
  MotionTime time;
  EXPECT_NEAR(time.secondsOf("G1 X50 F3000"), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(time.secondsOf("G5 X1 Y1 I0 J1 P0 Q1"), 0.0);
  EXPECT_DOUBLE_EQ(time.secondsOf("G1 X100"), 0.0);
}

}  // namespace
}  // namespace lamina
