// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/joint_servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

JointValues single(double value) { return JointValues::Constant(1, value); }

TEST(JointServo, FollowsAtOnceWithoutALag) {
  JointServo servo(0.0, 0.0, single(1.0));
  servo.follow(single(1.5), 0.1);
  EXPECT_EQ(servo.position()[0], 1.5);
  EXPECT_NEAR(servo.velocity()[0], 5.0, 1e-12);
  servo.stop();
  EXPECT_EQ(servo.velocity()[0], 0.0);
  EXPECT_EQ(servo.position()[0], 1.5);
}

TEST(JointServo, ComesNearerByItsTimeConstant) {
  JointServo first(0.2, 0.0, single(0.0));
  for (int i = 0; i < 10; ++i) first.follow(single(1.0), 0.02);
  EXPECT_NEAR(first.position()[0], 1.0 - std::exp(-1.0), 1e-12);
  // Of second order, critically damped: 1 - (1 + t/T) exp(-t/T).
  JointServo second(0.2, 1.0, single(0.0));
  for (int i = 0; i < 100; ++i) second.follow(single(1.0), 0.002);
  EXPECT_NEAR(second.position()[0], 1.0 - 2.0 * std::exp(-1.0), 2e-3);
}

}  // namespace
}  // namespace lamina
