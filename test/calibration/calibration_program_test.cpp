// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/calibration_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

const Point2 kSensorOffset(25.0, 0.0);

std::vector<Path> pathsOf(const Toolpath& toolpath, bool deposits) {
  std::vector<Path> found;
  for (const Path& path : toolpath.layers.at(0).paths)
    if ((path.role != PathRole::Travel) == deposits) found.push_back(path);
  return found;
}

TEST(CalibrationProgram, IsAToolpath) {
  const CalibrationSettings settings;
  for (const Toolpath& toolpath :
       {bobbingToolpath(settings, kSensorOffset), edgeToolpath(settings, kSensorOffset),
        crossToolpath(settings, kSensorOffset), feederToolpath(settings, kSensorOffset)})
    EXPECT_NO_THROW(validate(toolpath)) << toolpath.part_name;
}

TEST(CalibrationProgram, BobsEverFasterForAsLongAsAsked) {
  const CalibrationSettings settings;
  const Path bobbing = pathsOf(bobbingToolpath(settings, kSensorOffset), false).back();
  double duration_s = 0.0;
  double low = 1e9;
  double high = -1e9;
  for (std::size_t i = 1; i < bobbing.points.size(); ++i) {
    duration_s += (bobbing.points[i] - bobbing.points[i - 1]).norm() / bobbing.feed_mm_s.at(i);
    EXPECT_EQ(bobbing.points[i].x(), settings.x_mm - 25.0);
    EXPECT_TRUE(i < 2 || bobbing.feed_mm_s.at(i) > bobbing.feed_mm_s.at(i - 1));
    low = std::min(low, bobbing.points[i].z());
    high = std::max(high, bobbing.points[i].z());
  }
  EXPECT_NEAR(duration_s, settings.bob_s, 0.5 / settings.bob_high_hz);
  EXPECT_NEAR(high - low, 2.0 * settings.bob_mm, 1e-9);
  EXPECT_GE(low, settings.clearance_mm);
  // A triangle of amplitude A and frequency f has the speed 4 A f.
  EXPECT_NEAR(bobbing.feed_mm_s.at(bobbing.points.size() - 1), 4.0 * settings.bob_mm * settings.bob_high_hz,
              2.0);
}

TEST(CalibrationProgram, LaysNoBeadOfACrossTwice) {
  const CalibrationSettings settings;
  const std::vector<CalibrationBead> beads = crossBeads(settings);
  ASSERT_EQ(beads.size(), 7u);
  for (std::size_t i = 4; i < beads.size(); ++i)
    for (std::size_t j = 0; j < beads.size(); ++j)
      for (double part = 0.0; part <= 1.0 && i != j; part += 0.01) {
        const Point2 at = beads[i].start + part * (beads[i].end - beads[i].start);
        const Point2 along = beads[j].end - beads[j].start;
        const double nearest = std::clamp((at - beads[j].start).dot(along) / along.squaredNorm(), 0.0, 1.0);
        EXPECT_GT((at - beads[j].start - nearest * along).norm(), 1.5 * settings.bead_width_mm);
      }
  const auto deposited = pathsOf(crossToolpath(settings, kSensorOffset), true);
  ASSERT_EQ(deposited.size(), beads.size());
  EXPECT_EQ(deposited[4].points[0].head<2>(), beads[4].start);
}

TEST(CalibrationProgram, StepsTheFeederThereAndBack) {
  const CalibrationSettings settings;
  const auto deposited = pathsOf(feederToolpath(settings, kSensorOffset), true);
  ASSERT_EQ(deposited.size(), 2u);
  const double area = crossSection({settings.bead_width_mm, settings.bead_height_mm});
  for (const Path& bead : deposited) {
    ASSERT_EQ(bead.points.size(), 7u);
    EXPECT_NEAR(crossSection(bead.bead.at(1)), area, 1e-9);
    EXPECT_NEAR(crossSection(bead.bead.at(2)), 1.2 * area, 1e-9);
    EXPECT_NEAR(crossSection(bead.bead.at(3)), 0.8 * area, 1e-9);
    EXPECT_NEAR((bead.points[3] - bead.points[2]).norm(), settings.step_mm, 1e-9);
  }
  EXPECT_GT(deposited[0].points[1].y(), deposited[0].points[0].y());
  EXPECT_LT(deposited[1].points[1].y(), deposited[1].points[0].y());
}

TEST(CalibrationProgram, ScansAcrossWhatItDeposited) {
  CalibrationSettings settings;
  settings.swath_mm = 20.0;
  double least = 1e9;
  double greatest = -1e9;
  for (const Path& path : pathsOf(crossToolpath(settings, kSensorOffset), false))
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      if (path.feed_mm_s.at(i) != settings.scan_mm_s) continue;
      EXPECT_GT(std::abs(path.points[i].y() - path.points[i - 1].y()), settings.square_mm);
      EXPECT_GE(path.points[i].z(), settings.clearance_mm);
      least = std::min(least, path.points[i].x() + 25.0 - 0.5 * settings.swath_mm);
      greatest = std::max(greatest, path.points[i].x() + 25.0 + 0.5 * settings.swath_mm);
    }
  EXPECT_LE(least, settings.x_mm - 0.5 * settings.square_mm - 1.0);
  EXPECT_GE(greatest, settings.x_mm + 0.5 * settings.square_mm + 1.0);
}

}  // namespace
}  // namespace lamina
