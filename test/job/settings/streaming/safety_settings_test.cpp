// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Settings of safety hold to the second and the millimetre.
#include <gtest/gtest.h>

#include "job/settings/setting_probe.hpp"
#include "job/settings/streaming/silent_machine.hpp"
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

struct ResumedBy {
  const char* set;
  const char* lines;  ///< of the rest of a program, that stand in it by this setting alone
};

TEST(SafetySettings, TheRestOfAProgramPassesThePartAsItSays) {
  const SettingProbe probe = resumeProbes().front();
  const std::string usual = resultOf(probe, "", "");
  // By hand: the part is 0.4 mm high and is gone on with at 40, 40 mm; 10 mm of filament are purged.
  const ResumedBy resumed[] = {{"resume.purge_mm3=62.83185307179586", "G1 E20 F120\n"},
                               {"resume.purge_at_mm=-7,3", "G1 X-7 Y3 F3000\n"},
                               {"resume.clearance_mm=10", "G1 Z10.4 F3000\n"},
                               {"resume.tool_axis=0,-1,1", "G1 X40 Y35 F3000\nG1 X40 Y40 Z0.4 F600\n"},
                               {"resume.ramp_mm=30", "M220 S50\nG1 X20 E5\nG1 Y20 E6\nM220 S100\n"},
                               {"resume.filament_diameter_mm=4", "G1 E2.5 F120\n"},
                               {"resume.retraction_mm=3", "Z0.4 F600\nG1 E3 F120\n"},
                               {"resume.travel_feed_mm_s=30", "G1 Z5.4 F1800\n"},
                               {"resume.purge_feed_mm_s=1", "G1 E10 F60\n"}};
  for (const ResumedBy& one : resumed) {
    const std::string rest = resultOf(probe, "", one.set);
    EXPECT_NE(rest.find(one.lines), std::string::npos) << one.set << " gives\n" << rest;
    EXPECT_EQ(usual.find(one.lines), std::string::npos) << one.set;
  }
  EXPECT_EQ(resultOf(probe, "", "resume.ramp_mm=0").find("M220"), std::string::npos);
  EXPECT_TRUE(isRefusal(resultOf(probe, "", "resume.purge_at_mm=30,30"))) << "on the part";
  EXPECT_TRUE(isRefusal(resultOf(probe, "", "resume.clearance_mm=60"))) << "above the nozzle";
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
