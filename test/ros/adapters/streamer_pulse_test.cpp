// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/streamer_pulse.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

StartupReport reportOf(StartupStep step, StartupState state) {
  StartupStatus status;
  status.step = step;
  status.state = state;
  return {{status}, false};
}

/// Whether a watch has to stop the machine between jobs.
bool isAtWorkBetweenJobs(const StartupReport& startup) {
  return pulseOf({}, PackmlState::Idle, {}, startup).is_at_work;
}

TEST(StreamerPulse, IsAtWorkWhileSomethingMayBeOnWhateverTheStepsAre) {
  StartupReport lost = reportOf(StartupStep::HeatBed, StartupState::Pending);
  EXPECT_FALSE(isAtWorkBetweenJobs(lost));
  lost.may_be_on = true;
  EXPECT_TRUE(isAtWorkBetweenJobs(lost));
  EXPECT_FALSE(pulseOf({}, PackmlState::Idle, {}, lost).has_job);
}

TEST(StreamerPulse, IsAtWorkWhileAStepIsRun) {
  EXPECT_TRUE(isAtWorkBetweenJobs(reportOf(StartupStep::HomeX, StartupState::Running)));
  EXPECT_FALSE(isAtWorkBetweenJobs(reportOf(StartupStep::HomeX, StartupState::Done)));
  EXPECT_FALSE(isAtWorkBetweenJobs(reportOf(StartupStep::DryPellets, StartupState::Running)))
      << "the operator switched the dryer on";
}

TEST(StreamerPulse, IsAtWorkWithAJobUnlessAPrintServerHasIt) {
  GcodeStreamerSettings settings;
  EXPECT_TRUE(pulseOf(settings, PackmlState::Held, {}, {}).is_at_work);
  EXPECT_FALSE(pulseOf(settings, PackmlState::Complete, {}, {}).is_at_work);
  settings.port.name = "http://octopi";
  EXPECT_FALSE(pulseOf(settings, PackmlState::Held, {}, {}).is_at_work);
}

}  // namespace
}  // namespace lamina
