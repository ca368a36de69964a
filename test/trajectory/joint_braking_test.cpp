// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/joint_braking.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

const std::vector<DrivenJoint> kTwoJoints = {{"arm", JointKind::Rotary, -1.0, 2.0, 4.0},
                                             {"rail", JointKind::Linear, 0.0, 500.0, 100.0}};

JointValues both(double first, double second) {
  JointValues values(2);
  values << first, second;
  return values;
}

TEST(JointBraking, TakesAsLongAsTheJointThatIsFastestForItself) {
  EXPECT_EQ(brakeTime(both(0.0, 0.0), kTwoJoints, 0.4), 0.0);
  EXPECT_NEAR(brakeTime(both(-2.0, 10.0), kTwoJoints, 0.4), 0.2, 1e-12);
  EXPECT_NEAR(brakeTime(both(1.0, -75.0), kTwoJoints, 0.4), 0.3, 1e-12);
}

TEST(JointBraking, HasTheRoomThatIsLeftToALimit) {
  EXPECT_TRUE(std::isinf(brakeRoom(both(0.0, 0.0), both(0.0, 0.0), kTwoJoints)));
  // Half the speed on average: 1 rad at 2 rad/s takes 1 s.
  EXPECT_NEAR(brakeRoom(both(1.0, 100.0), both(2.0, 0.0), kTwoJoints), 1.0, 1e-12);
  EXPECT_NEAR(brakeRoom(both(1.0, 10.0), both(2.0, -50.0), kTwoJoints), 0.4, 1e-12);
  EXPECT_EQ(brakeRoom(both(2.1, 10.0), both(0.5, 0.0), kTwoJoints), 0.0) << "beyond it already";
}

}  // namespace
}  // namespace lamina
