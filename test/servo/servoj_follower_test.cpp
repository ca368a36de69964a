// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_follower.hpp"

#include <gtest/gtest.h>

#include "servo/servo_arm.hpp"

namespace lamina::test {
namespace {

constexpr double kServoCycle = 0.002;  // s

/// What is sent in a cycle of a motion.
CyclicTarget targetOf(const std::function<JointState(double)>& motion, std::int64_t cycle, double ahead_s) {
  const JointState now = motion(kServoCycle * static_cast<double>(cycle));
  const JointState ahead = motion(kServoCycle * static_cast<double>(cycle) + ahead_s);
  return {cycle, {now.position, now.velocity}, {ahead.position, ahead.velocity}};
}

TEST(ServojFollower, WaitsForItsFirstTargetAndFollows) {
  ServojFollower robot({}, 0.0, sixValues(0.3));
  for (int i = 0; i < 100; ++i) robot.cycle();
  EXPECT_EQ(robot.report().state, ServojState::Waiting);
  EXPECT_EQ(robot.position()[0], 0.3);
  for (int k = 1; k <= 500; ++k) {
    robot.hear(targetOf(steadily, k, 0.02));
    robot.cycle();
    EXPECT_NEAR(robot.position()[0], kServoCycle * k, 1e-9);
  }
  EXPECT_EQ(robot.report().state, ServojState::Following);
  EXPECT_EQ(robot.report().cycle, 500);
  EXPECT_EQ(robot.following().cycles, 500U);
  EXPECT_EQ(robot.following().bridged, 0U);
}

TEST(ServojFollower, FollowsWhereTheNumbersOfCyclesBeginAgain) {
  ServojFollower robot({}, 0.0, sixValues(0.0));
  for (int k = 1; k <= 500; ++k) {
    CyclicTarget target = targetOf(steadily, k, 0.02);
    target.cycle = (1LL << 31) - 251 + k;
    robot.hear(lamina::targetOf(targetBytes(target)).target);
    robot.cycle();
    ASSERT_EQ(robot.report().state, ServojState::Following) << k;
    EXPECT_NEAR(robot.position()[0], kServoCycle * k, 2e-6);
  }
  EXPECT_EQ(robot.report().cycle, 250);
  EXPECT_EQ(robot.following().bridged, 0U);
}

TEST(ServojFollower, LagsAsItsServoDoes) {
  ServojFollower robot({}, 0.02, sixValues(0.0));
  for (int k = 1; k <= 500; ++k) {
    robot.hear(targetOf(steadily, k, 0.02));
    robot.cycle();
  }
  // A lag of first order in steps: step / (1 - exp(-step / lag)) - step behind.
  const double behind = kServoCycle / (1.0 - std::exp(-0.1)) - kServoCycle;
  EXPECT_NEAR(robot.position()[0], 1.0 - behind, 1e-6);
}

TEST(ServojFollower, GoesOnAsPlannedWithoutNewTargets) {
  ServojFollower robot({}, 0.0, sixValues(0.5));
  for (int k = 1; k <= 500; ++k) {
    if (k % 7 != 3 && k % 7 != 4) robot.hear(targetOf(round, k, 0.02));
    robot.cycle();
    EXPECT_NEAR(robot.position().norm(), 0.5, 1e-7);
    EXPECT_NEAR(std::atan2(robot.position()[1], robot.position()[0]), kServoCycle * k, 1e-5);
  }
  EXPECT_EQ(robot.following().without, 0U);
  EXPECT_EQ(robot.following().bridged, 143U);
}

TEST(ServojFollower, StopsOnThePathAfterASilence) {
  ServojSettings settings;
  settings.stop_rad_s2 = 5.0;
  ServojFollower robot(settings, 0.0, sixValues(0.0));
  for (int k = 1; k <= 500; ++k) {
    robot.hear(targetOf(steadily, k, 0.02));
    robot.cycle();
  }
  int cycles = 0;
  while (robot.report().state != ServojState::Silent && cycles < 100) {
    robot.cycle();
    ++cycles;
  }
  EXPECT_EQ(cycles, 11) << "ten without a target, and that which brakes";
  while (!robot.isAtRest()) robot.cycle();
  // 20 ms on, and 1 rad/s to rest by 5 rad/s2.
  EXPECT_NEAR(robot.position()[0], 1.0 + 0.02 + 0.1, 1e-6);
  robot.hear(targetOf(steadily, 600, 0.02));
  for (int i = 0; i < 10; ++i) robot.cycle();
  EXPECT_EQ(robot.report().state, ServojState::Silent) << "for good";
  EXPECT_NEAR(robot.position()[0], 1.12, 1e-6);
}

TEST(ServojFollower, EndsWhenItIsAskedTo) {
  ServojFollower robot({}, 0.0, sixValues(0.0));
  for (int k = 1; k <= 500; ++k) {
    robot.hear(targetOf(steadily, k, 0.02));
    robot.cycle();
  }
  robot.end();
  robot.cycle();
  EXPECT_EQ(robot.report().state, ServojState::Ended);
  while (!robot.isAtRest()) robot.cycle();
  EXPECT_NEAR(robot.position()[0], 1.0 + 0.05, 1e-6) << "by 10 rad/s2";
}

TEST(ServojFollower, CountsWhatLiesBeyondWhatWasPlanned) {
  ServojSettings patient;
  patient.silence_s = 0.3;
  ServojFollower robot(patient, 0.0, sixValues(0.0));
  for (int k = 1; k <= 100; ++k) {
    robot.hear(targetOf(steadily, k, patient.ahead()));
    robot.cycle();
  }
  for (int i = 0; i < 100; ++i) robot.cycle();
  EXPECT_GT(robot.following().without, 0U);
  EXPECT_NEAR(robot.position()[0], 0.2 + 0.1, 1e-6) << "stands where the plan ends";
  robot.hear(targetOf(steadily, 400, patient.ahead()));
  robot.cycle();
  EXPECT_NEAR(robot.position()[0], 0.8, 0.25) << "takes up the count again";
}

}  // namespace
}  // namespace lamina::test
