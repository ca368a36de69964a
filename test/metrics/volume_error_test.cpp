// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/volume_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

Toolpath volumeErrorStraight(double length_mm) {
  return {"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {length_mm, 0, 0.2})}}}};
}

/// Strands of 0.08 mm2, whatever the bead.
VolumeErrorSettings ofStrands() {
  VolumeErrorSettings settings;
  settings.section = VolumeSection::Strand;
  return settings;
}

double estimated(const Toolpath& toolpath, StrandEnds ends) {
  VolumeErrorSettings settings = ofStrands();
  settings.ends = ends;
  return estimatedVolume(toolpath, settings);
}

TEST(VolumeError, OfAStraightStrandIsThatOfTheSource) {
  // A section of 0.08 mm2 is a disc of 0.319154 mm.
  EXPECT_NEAR(estimated(volumeErrorStraight(100.0), StrandEnds::Whole), 8.0, 1e-9);
  EXPECT_NEAR(estimated(volumeErrorStraight(100.0), StrandEnds::Generated), 8.0 - 0.08 * 0.319154, 1e-6);
  EXPECT_NEAR(estimated(volumeErrorStraight(100.0), StrandEnds::Commercial), 8.0 - 0.04 * 0.319154, 1e-6);
}

TEST(VolumeError, SegmentsShorterThanWhatTheirEndsTakeHaveNone) {
  EXPECT_EQ(estimated(volumeErrorStraight(0.3), StrandEnds::Generated), 0.0);
  EXPECT_GT(estimated(volumeErrorStraight(0.3), StrandEnds::Commercial), 0.0);
}

TEST(VolumeError, BeadsCountByTheirOwnSection) {
  VolumeErrorSettings settings;
  settings.section = VolumeSection::Bead;
  EXPECT_NEAR(estimatedVolume(volumeErrorStraight(100.0), settings), 100.0 * (0.2 * 0.2 + M_PI * 0.01), 1e-9);
}

TEST(VolumeError, IsWithoutSignAndOfTheShareAskedFor) {
  VolumeErrorSettings settings = ofStrands();
  EXPECT_NEAR(volumeError(volumeErrorStraight(100.0), 8.0, settings), 0.0, 1e-9);
  EXPECT_NEAR(volumeError(volumeErrorStraight(100.0), 10.0, settings), 2.0, 1e-9);
  EXPECT_NEAR(volumeError(volumeErrorStraight(100.0), 7.0, settings), 1.0, 1e-9);
  settings.fill_share = 0.5;
  EXPECT_NEAR(volumeError(volumeErrorStraight(100.0), 16.0, settings), 0.0, 1e-9);
}

TEST(VolumeError, SkirtsAndTravelsAreNotOfThePart) {
  Toolpath toolpath = volumeErrorStraight(100.0);
  Path skirt = toolpath.layers[0].paths[0];
  skirt.role = PathRole::Skirt;
  Path travel = skirt;
  travel.role = PathRole::Travel;
  toolpath.layers[0].paths.push_back(skirt);
  toolpath.layers[0].paths.push_back(travel);
  EXPECT_NEAR(estimatedVolume(toolpath, ofStrands()), 8.0, 1e-9);
}

}  // namespace
}  // namespace lamina
