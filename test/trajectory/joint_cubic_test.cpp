// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/joint_cubic.hpp"

#include <gtest/gtest.h>

#include "lamina/trajectory/joint_trajectory.hpp"

namespace lamina {
namespace {

JointState oneJoint(double time_s, double position, double velocity) {
  JointState state;
  state.time_s = time_s;
  state.position = JointValues::Constant(1, position);
  state.velocity = JointValues::Constant(1, velocity);
  return state;
}

TEST(JointCubic, IsTheCubicThroughPlacesAndSpeedsOfBothEnds) {
  // x = t^3 - 2 t + 1 from 1 to 3 s
  const JointState from = oneJoint(1.0, 0.0, 1.0);
  const JointState to = oneJoint(3.0, 22.0, 25.0);
  for (const double t : {1.0, 1.3, 2.0, 2.9, 3.0}) {
    EXPECT_NEAR(cubicPosition(from, to, t)[0], t * t * t - 2.0 * t + 1.0, 1e-12);
    EXPECT_NEAR(cubicVelocity(from, to, t)[0], 3.0 * t * t - 2.0, 1e-12);
  }
}

}  // namespace
}  // namespace lamina
