// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_messages.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const std::vector<DrivenJoint> kJoints = {{"x", JointKind::Linear, 0, 300, 100},
                                          {"b", JointKind::Rotary, -1, 1, 2}};

JointState stateOf(double x, double b) {
  JointState state;
  state.position = state.velocity = state.acceleration = JointValues::Zero(2);
  state.position << x, b;
  state.velocity << 2 * x, 2 * b;
  return state;
}

TEST(JointMessages, LinearJointsGoInMetresRotaryOnesInRadians) {
  const auto point = toMessage(stateOf(120.0, 0.5), kJoints);
  EXPECT_EQ(point.positions, (std::vector<double>{0.12, 0.5}));
  EXPECT_EQ(point.velocities, (std::vector<double>{0.24, 1.0}));
}

TEST(JointMessages, ComeBackInWhateverOrderTheJointsAreNamed) {
  auto point = toMessage(stateOf(120.0, 0.5), kJoints);
  std::swap(point.positions[0], point.positions[1]);
  std::swap(point.velocities[0], point.velocities[1]);
  point.accelerations.clear();
  const JointState state = fromMessage(point, {"b", "x"}, kJoints);
  EXPECT_NEAR(state.position[0], 120.0, 1e-12);
  EXPECT_NEAR(state.velocity[1], 1.0, 1e-12);
  EXPECT_TRUE(state.acceleration.isZero());
}

TEST(JointMessages, PointsThatDoNotFitTheJointsAreRefused) {
  auto point = toMessage(stateOf(120.0, 0.5), kJoints);
  EXPECT_THROW(fromMessage(point, {"x"}, kJoints), InvalidInput);
  EXPECT_THROW(fromMessage(point, {"x", "c"}, kJoints), InvalidInput);
  point.velocities.pop_back();
  EXPECT_THROW(fromMessage(point, {"x", "b"}, kJoints), InvalidInput);
  point = toMessage(stateOf(std::numeric_limits<double>::quiet_NaN(), 0.5), kJoints);
  EXPECT_THROW(fromMessage(point, {"x", "b"}, kJoints), InvalidInput);
}

TEST(JointMessages, ProcessSignalsComeBack) {
  ProcessSignals signals;
  signals.flow_mm3_s = 12.5;
  signals.is_laser_on = signals.is_gas_on = true;
  const ProcessSignals back = fromMessage(toMessage(signals));
  EXPECT_NEAR(back.flow_mm3_s, 12.5, 1e-12);
  EXPECT_TRUE(back.is_laser_on && back.is_gas_on);
  EXPECT_FALSE(back.is_wire_fed || back.is_powder_on);
  EXPECT_TRUE(back.levels == ProcessLevels());
}

TEST(JointMessages, ProcessLevelsAreInSi) {
  ProcessSignals signals;
  signals.levels[ProcessLevel::LaserPower] = 900.0;
  signals.levels[ProcessLevel::WireSpeed] = 12.0;
  signals.levels[ProcessLevel::ScrewSpeed] = 60.0;
  signals.levels[ProcessLevel::Powder] = 12.0;
  signals.levels[ProcessLevel::Gas] = 15.0;
  signals.levels[ProcessLevel::Fan] = 0.4;
  const lamina_msgs::ProcessPoint point = toMessage(signals);
  EXPECT_EQ(point.laser_power, 900.0);
  EXPECT_NEAR(point.wire_speed, 0.012, 1e-15);
  EXPECT_NEAR(point.screw_speed, 2.0 * M_PI, 1e-12);
  EXPECT_NEAR(point.powder_rate, 0.0002, 1e-15);
  EXPECT_NEAR(point.gas_rate, 0.00025, 1e-15);
  EXPECT_EQ(point.fan, 0.4);
  const ProcessLevels back = fromMessage(point).levels;
  for (const ProcessLevel level : kAllProcessLevels)
    EXPECT_NEAR(back[level], signals.levels[level], 1e-9) << nameOf(level);
}

}  // namespace
}  // namespace lamina
