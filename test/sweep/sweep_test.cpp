// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "sweep/specimen.hpp"

namespace lamina {
namespace {

SweepSettings with(CornerStrategy corners) {
  SweepSettings settings;
  settings.corners = corners;
  return settings;
}

Toolpath loop() {
  return test::layered({0.3}, [](std::size_t, double z, double h) {
    return std::vector<Path>{test::ring({{2, 2, z}, {41.5, 2, z}, {41.5, 6.5, z}, {2, 6.5, z}}, {0.4968, h})};
  });
}

TEST(Sweep, LoopIsTwoSections) {
  const std::vector<Sweep> sweeps = sweepsOf(loop(), with(CornerStrategy::Sections));
  ASSERT_EQ(sweeps.size(), 2U);
  EXPECT_EQ(sweeps[0].points.size(), 4U);
  ASSERT_EQ(sweeps[1].points.size(), 2U);
  EXPECT_EQ(sweeps[1].points[0], Point3(2, 6.5, 0.3));
  EXPECT_EQ(sweeps[1].points[1], Point3(2, 2, 0.3));
  EXPECT_NEAR(sweeps[1].bead.width_mm, 0.4968, 1e-12);
}

TEST(Sweep, LoopIsOneWholeOrFourLines) {
  const std::vector<Sweep> whole = sweepsOf(loop(), with(CornerStrategy::Whole));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole[0].is_loop);
  EXPECT_EQ(sweepsOf(loop(), with(CornerStrategy::Lines)).size(), 4U);
  EXPECT_NEAR(sweptVolume(whole), totals(loop()).deposited_mm3, 1e-9);
}

TEST(Sweep, LeavesOutSkirtAndTravel) {
  Toolpath toolpath = loop();
  std::vector<Path>& paths = toolpath.layers[0].paths;
  paths.resize(3, paths[0]);
  paths[1].role = PathRole::Skirt;
  paths[2].role = PathRole::Travel;
  EXPECT_EQ(sweepsOf(toolpath, with(CornerStrategy::Whole)).size(), 1U);
}

TEST(Sweep, BeadThatChangesHasItsMeanSection) {
  Path path = test::bead({{0, 0, 0.3}, {10, 0, 0.3}, {20, 5, 0.3}}, {});
  path.bead = AlongPath<Bead>({Bead{}, Bead{0.4, 0.3}, Bead{0.6, 0.3}});
  Toolpath toolpath;
  toolpath.layers = {{0.3, 0.3, {path}}};
  const std::vector<Sweep> sweeps = sweepsOf(toolpath, with(CornerStrategy::Whole));
  EXPECT_NEAR(sweptVolume(sweeps), depositedVolume(path), 1e-12);
}

TEST(Sweep, AbsoluteHeightWidensTheCutsOfUpperLayers) {
  // Ends 0.17 mm apart: more than half of 0.3 mm, less than half of 1.5 (1 - pi/4) + 0.0707 / 1.5 = 0.369 mm.
  const Toolpath toolpath = test::layered({1.2, 1.5}, [](std::size_t, double z, double h) {
    std::vector<Path> paths;
    if (h < 0.5) paths = {test::bead({{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 0.17, z}}, {0.3, h})};
    return paths;
  });
  SweepSettings settings;
  EXPECT_EQ(sweepsOf(toolpath, settings).size(), 1U);
  settings.cut_height = CutHeight::Absolute;
  EXPECT_EQ(sweepsOf(toolpath, settings).size(), 2U);
}

TEST(Sweep, RefusesDrops) {
  Toolpath toolpath = loop();
  toolpath.layers[0].paths[0].deposit = Deposit::Drops;
  EXPECT_THROW(sweepsOf(toolpath, {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
