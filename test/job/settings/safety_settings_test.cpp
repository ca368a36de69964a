// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Settings of safety hold to the second and the millimetre.
#include <gtest/gtest.h>

#include "job/settings/setting_probe.hpp"
#include "job/settings/silent_machine.hpp"
#include "lamina/trajectory/approach.hpp"

namespace lamina::test {
namespace {

/// When a state is entered of a job on a silent machine.
double enteredAt(PackmlState state, Silence silence, const std::string& program, const std::string& set) {
  const SilentJob job = streamedTo(
      silence, settingsWith<StreamSettings>(settingTexts("stream.temperature_interval_s=0;" + set)), program);
  const auto entered = job.entered_s.find(state);
  return entered == job.entered_s.end() ? -1.0 : entered->second;
}

TEST(SafetySettings, AMachineThatNeverAnswersIsGivenUpAfterItsTime) {
  for (const double limit_s : {4.0, 10.0})
    EXPECT_NEAR(enteredAt(PackmlState::Aborting, Silence::FromTheStart, kTenMoves,
                          "stream.connect_timeout_s=" + std::to_string(limit_s)),
                limit_s, 1e-6);
}

TEST(SafetySettings, ASilentMachineIsAbortedAfterItsTime) {
  for (const double limit_s : {20.0, 60.0})
    EXPECT_NEAR(enteredAt(PackmlState::Aborting, Silence::OnceBegun, kTenMoves,
                          "stream.silence_timeout_s=" + std::to_string(limit_s)),
                limit_s, 1e-6);
}

TEST(SafetySettings, AMachineThatHomesHasTheLongerTime) {
  for (const double limit_s : {600.0, 3600.0})
    EXPECT_NEAR(enteredAt(PackmlState::Aborting, Silence::OnceBegun, "G28\nG1 X1\n",
                          "stream.blocking_timeout_s=" + std::to_string(limit_s)),
                limit_s, 1e-6);
}

TEST(SafetySettings, ASafeStopIsWaitedForAsLongAsItSays) {
  for (const double limit_s : {3.0, 10.0})
    EXPECT_NEAR(enteredAt(PackmlState::Aborted, Silence::FromTheAbort, kTenMoves,
                          "stream.safe_stop_timeout_s=" + std::to_string(limit_s)),
                1.0 + limit_s, 1e-6);
}

TEST(SafetySettings, AnApproachLiftsAsFarAndAsFastAsItSays) {
  const auto model = kinematicModelByName("cartesian_gantry");
  JointValues from(3), to(3);
  from << 50, 50, 20;
  to << 120, 90, 30;
  for (const double lift_mm : {10.0, 20.0}) {
    const Approach way = approach(from, to, *model, {lift_mm, 5.0, 0.5}, {});
    double highest = 0.0, fastest = 0.0;
    for (double t = 0.0; t < way.motion->duration(); t += 0.01) {
      const JointState state = way.motion->at(t);
      highest = std::max(highest, state.position[2]);
      if (state.position[0] == from[0]) fastest = std::max(fastest, std::abs(state.velocity[2]));
    }
    EXPECT_NEAR(highest, 30.0 + lift_mm, 0.01);
    EXPECT_NEAR(fastest, 5.0, 1e-6);
  }
}

}  // namespace
}  // namespace lamina::test
