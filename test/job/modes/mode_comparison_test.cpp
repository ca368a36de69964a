// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modes/mode_comparison.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class ModeComparisonTest : public ::testing::Test {
 protected:
  ModeComparisonTest() {
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.bead.width_mm = 0.8;
    job_.settings.machine.name = "five_axis_head_table";
    job_.part = folder_.file("tee.stl");
    writeStl(job_.part, makePart("tee", {{"stem_mm", "10"},
                                         {"stem_height_mm", "24"},
                                         {"bar_mm", "22"},
                                         {"bar_height_mm", "4"},
                                         {"width_mm", "8"}}));
  }

  ModeComparison compared(const std::vector<std::string>& modes) {
    NoProgress nobody;
    return compareModes(job_, modes, nobody);
  }

  test::ScratchFolder folder_;
  SliceJob job_;
};

TEST_F(ModeComparisonTest, EachModeShowsWhatItLeavesUnsupported) {
  const ModeComparison comparison = compared({"planar", "multi_direction", "volumetric"});
  ASSERT_EQ(comparison.modes.size(), 3U);
  // The undersides of both arms, 6 x 8 mm each.
  EXPECT_NEAR(surfaceArea(comparison.modes[0].unsupported), 96.0, 1e-4);
  const double surface = surfaceArea(comparison.part);
  for (const ComparedMode& mode : comparison.modes) {
    EXPECT_FALSE(mode.toolpath.layers.empty()) << mode.candidate.mode;
    // Of the whole surface, the foot too, whatever the mode.
    EXPECT_NEAR(surfaceArea(mode.unsupported), 0.01 * mode.candidate.unsupported_percent * surface,
                1e-6 * surface)
        << mode.candidate.mode;
  }
  EXPECT_GT(comparison.modes[2].candidate.unsupported_percent, 0.1) << "volumetric leaves some";
  ASSERT_TRUE(comparison.chosen.has_value());
  EXPECT_EQ(comparison.modes[*comparison.chosen].candidate.mode, "multi_direction");
}

// A plate 2 mm high at 20 mm, over a box as high: a coat would lie above 22 mm.
TEST_F(ModeComparisonTest, WhatIsDepositedOnABaseIsComparedOnIt) {
  job_.settings.conformal.base = folder_.file("box.stl");
  writeStl(job_.settings.conformal.base, makePart("box"));
  Mesh plate = makePart("box", {{"z_mm", "2"}});
  for (Point3& vertex : plate.vertices) vertex.z() += 20.0;
  job_.part = folder_.file("plate.stl");
  writeStl(job_.part, plate);
  const ModeComparison comparison = compared({"conformal"});
  ASSERT_EQ(comparison.modes.front().candidate.refusal, "");
  Box3 tips;
  for (const ToolpathLayer& layer : comparison.modes.front().toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::OuterWall)
        for (const Point3& tip : path.points) tips.include(tip);
  EXPECT_NEAR(tips.low.z(), 20.5, 1e-6);
  EXPECT_NEAR(tips.high.z(), 22.0, 1e-6);
  EXPECT_FALSE(comparison.chosen.has_value());
}

TEST_F(ModeComparisonTest, APartIsComparedAsLargeAsItIsDeposited) {
  job_.settings.compensation.shrink_z = 0.2;
  const ModeComparison comparison = compared({"planar"});
  // 28 mm as drawn, in layers of 0.5 mm.
  EXPECT_NEAR(boundingBox(comparison.part).size().z(), 35.0, 1e-4);
  EXPECT_EQ(comparison.modes.front().candidate.layers, 70U);
}

TEST_F(ModeComparisonTest, APartLargerThanTheMachineIsRefused) {
  job_.part = folder_.file("beam.stl");
  writeStl(job_.part, makePart("box", {{"x_mm", "5000"}}));
  EXPECT_THROW(compared({"planar"}), Unreachable);
}

TEST_F(ModeComparisonTest, APlaneThatTheHeadCannotLayIsRefused) {
  job_.settings.machine.name = "gantry_45";
  job_.settings.slicing.plane.angle_deg = 30.0;
  EXPECT_THROW(compared({"inclined"}), Unreachable);
}

TEST_F(ModeComparisonTest, ARefusalStandsInItsPlace) {
  const ModeComparison comparison = compared({"adapted"});
  EXPECT_NE(comparison.modes.front().candidate.refusal.find("adapted.max_lean_deg"), std::string::npos);
  EXPECT_TRUE(comparison.modes.front().toolpath.layers.empty());
  EXPECT_FALSE(comparison.chosen.has_value());
}

std::string chosenIn(const ModeComparison& comparison) {
  return comparison.chosen ? comparison.modes[*comparison.chosen].candidate.mode : "none";
}

// Whatever the order in which they are asked for.
TEST_F(ModeComparisonTest, TheChosenOneIsWhatAutoTakes) {
  job_.settings.automatic.good_unsupported_percent = 20.0;
  EXPECT_EQ(chosenIn(compared({"volumetric", "planar"})), "planar");
  job_.settings.automatic.good_unsupported_percent = 1.0;
  EXPECT_EQ(chosenIn(compared({"volumetric", "multi_direction", "planar"})), "multi_direction");
}

TEST_F(ModeComparisonTest, NothingIsChosenBesideWhatAutoWouldTry) {
  EXPECT_EQ(chosenIn(compared({"volumetric"})), "none") << "planar comes first";
  EXPECT_EQ(chosenIn(compared({"planar", "volumetric"})), "none") << "multi_direction may be good enough";
  job_.settings.automatic.follows_skins = true;
  EXPECT_EQ(chosenIn(compared({"planar"})), "none");
}

TEST_F(ModeComparisonTest, AHeadThatCannotTiltIsChosenLevelLayersFor) {
  job_.settings.machine.name = "cartesian_gantry";
  EXPECT_EQ(chosenIn(compared({"volumetric", "planar"})), "planar");
}

TEST_F(ModeComparisonTest, WhatIsComparedFollowsFromTheMachine) {
  EXPECT_EQ(comparableModes(job_),
            (std::vector<std::string>{"planar", "multi_direction", "adapted", "volumetric", "curved"}));
  job_.settings.machine.name = "cartesian_gantry";
  EXPECT_EQ(comparableModes(job_), (std::vector<std::string>{"planar", "heightfield"}));
  job_.settings.machine.name = "gantry_45";
  EXPECT_EQ(comparableModes(job_), (std::vector<std::string>{"inclined"}));
}

TEST_F(ModeComparisonTest, ModesThatAreNoneOrTwiceAreRefused) {
  EXPECT_THROW(compared({}), InvalidConfig);
  EXPECT_THROW(compared({"planar", "planar"}), InvalidConfig);
  EXPECT_THROW(compared({"wavy"}), InvalidConfig);
  EXPECT_THROW(compared({"auto"}), InvalidConfig);
}

}  // namespace
}  // namespace lamina
