// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/kept_feed.hpp"

#include <gtest/gtest.h>

#include "lamina/trajectory/timed_path.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

const test::TiltingGantry kGantry;

/// A bead of 100 mm in steps of 1 mm.
Toolpath beadAt(double feed_mm_s, PathRole role) {
  Path bead = test::straightPath({0, 0, 0.2}, {1, 0, 0.2});
  for (int i = 2; i <= 100; ++i) bead.points.emplace_back(i, 0, 0.2);
  bead.feed_mm_s = feed_mm_s;
  bead.role = role;
  return {"bead", {{0.2, 0.2, {bead}}}};
}

double shareOf(const Toolpath& toolpath) {
  TimingSettings settings;
  settings.motion.acceleration_mm_s2 = 300.0;
  settings.motion.travel_acceleration_mm_s2 = 300.0;
  settings.trajectory.jerk_ramp_s = 0.0;
  settings.trajectory.joint_ramp_s = 0.01;
  const JointPath path = test::uprightPath(toolpath, kGantry);
  return slowBeadShare(TimedPath(toolpath, path, kGantry, settings), path, toolpath);
}

TEST(KeptFeed, IsMissedWhereABeadStartsAndEnds) {
  // 30 mm/s at 300 mm/s2: 95 % of it after 0.9025 * 1.5 mm, at both ends of 100 mm.
  EXPECT_NEAR(shareOf(beadAt(30.0, PathRole::Infill)), 2.0 * 0.9025 * 1.5 / 100.0, 0.004);
}

TEST(KeptFeed, IsMissedAllAlongWhereAJointIsTooSlow) {
  // Joint x reaches 200 mm/s.
  EXPECT_DOUBLE_EQ(shareOf(beadAt(220.0, PathRole::Infill)), 1.0);
}

/// The share where a firmware plans with 300 mm/s2.
double shareByFirmware(const Toolpath& toolpath) {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 300.0;
  return slowBeadShare(toolpath, limits);
}

TEST(KeptFeed, OfAFirmwareIsMissedOnTheSameRamps) {
  EXPECT_NEAR(shareByFirmware(beadAt(30.0, PathRole::Infill)), 2.0 * 0.9025 * 1.5 / 100.0, 1e-9);
}

TEST(KeptFeed, OfAFirmwareKnowsNothingOfJoints) {
  // Of 220 mm/s at most sqrt(300 * 100) = 173 are reached, within 100 mm. 150 mm/s are: 95 % of them after
  // 0.9025 * 37.5 mm, though joint x is not asked.
  EXPECT_DOUBLE_EQ(shareByFirmware(beadAt(220.0, PathRole::Infill)), 1.0);
  EXPECT_NEAR(shareByFirmware(beadAt(150.0, PathRole::Infill)), 2.0 * 0.9025 * 37.5 / 100.0, 1e-9);
  EXPECT_DOUBLE_EQ(shareByFirmware(beadAt(220.0, PathRole::Travel)), 0.0);
}

TEST(KeptFeed, IsAskedOfBeadsAlone) { EXPECT_DOUBLE_EQ(shareOf(beadAt(220.0, PathRole::Travel)), 0.0); }

}  // namespace
}  // namespace lamina
