// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/simulated_controller/awaited_process.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

ros::Time at(double time_s) { return ros::Time(1000.0 + time_s); }

/// A client whose process came with its last goal, at 0 s.
AwaitedProcess afterAJob() {
  AwaitedProcess awaited(60.0);
  awaited.hearProcess(at(0.0));
  awaited.hearGoal(at(0.0));
  return awaited;
}

TEST(AwaitedProcess, AGoalWithoutItsProcessAwaitsIt) {
  AwaitedProcess awaited = afterAJob();
  EXPECT_FALSE(awaited.first());
  awaited.hearGoal(at(2.0));
  awaited.hearGoal(at(3.0));
  EXPECT_EQ(awaited.first(), at(2.0));
  awaited.hearProcess(at(2.0));
  EXPECT_EQ(awaited.first(), at(3.0));
  awaited.hearProcess(at(3.0));
  EXPECT_FALSE(awaited.first());
}

TEST(AwaitedProcess, AProcessMayComeFirst) {
  AwaitedProcess awaited = afterAJob();
  for (const double time_s : {1.0, 2.0, 3.0}) awaited.hearProcess(at(time_s));
  for (const double time_s : {1.0, 2.0, 3.0}) {
    awaited.hearGoal(at(time_s));
    EXPECT_FALSE(awaited.first()) << time_s;
  }
}

TEST(AwaitedProcess, AGoalThatReplacesALaterOneAwaitsItsOwn) {
  AwaitedProcess awaited = afterAJob();
  awaited.hearProcess(at(1.0));
  awaited.hearGoal(at(1.0));
  awaited.hearGoal(at(0.5));  // a pause
  EXPECT_EQ(awaited.first(), at(0.5));
  awaited.hearProcess(at(0.5));
  EXPECT_FALSE(awaited.first());
}

TEST(AwaitedProcess, OneThatWasLostIsNotAwaitedOnceALaterOneHasCome) {
  AwaitedProcess awaited = afterAJob();
  awaited.hearGoal(at(1.0));
  awaited.hearGoal(at(2.0));
  awaited.hearProcess(at(2.0));
  EXPECT_FALSE(awaited.first());
}

TEST(AwaitedProcess, OfAClientThatSendsNoneNoneIsAwaited) {
  AwaitedProcess never(60.0);
  never.hearGoal(at(1.0));
  EXPECT_FALSE(never.first());
  AwaitedProcess awaited = afterAJob();
  awaited.hearGoal(at(60.5));
  EXPECT_FALSE(awaited.first());
  awaited.hearGoal(at(59.5));
  EXPECT_TRUE(awaited.first());
  awaited.forgetGoals();
  EXPECT_FALSE(awaited.first());
}

}  // namespace
}  // namespace lamina
