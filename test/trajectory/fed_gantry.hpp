// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "lamina/trajectory/trajectory_feeder.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina::test {

inline TimingSettings powderSettings(double jerk_ramp_s = 0.0) {
  TimingSettings settings;
  settings.process.kind = ProcessKind::Powder;
  settings.trajectory.jerk_ramp_s = jerk_ramp_s;
  return settings;
}

inline TimedPath timedGantry(const Toolpath& toolpath, const TimingSettings& settings) {
  const TiltingGantry gantry;
  return {toolpath, uprightPath(toolpath, gantry), gantry, settings};
}

inline void expectSame(const JointState& a, const JointState& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.acceleration, b.acceleration);
}

/// A bead of 30 mm along x.
inline Toolpath trajectoryFeederLine() {
  return {"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {30, 0, 0.2})}}}};
}

/// That may go three times as fast as planned, with a reaction of 0.1 s.
inline TrajectoryFeederSettings fastFeeder() {
  TrajectoryFeederSettings settings;
  settings.reaction_s = 0.1;
  settings.feed_most = 3.0;
  return settings;
}

}  // namespace lamina::test
