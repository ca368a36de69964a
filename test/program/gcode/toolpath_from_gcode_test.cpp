// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "support/random_toolpath.hpp"

namespace lamina {
namespace {

constexpr double kPositionRounding = 0.5e-3 * (1 + 1e-6);  // mm: half the last decimal
constexpr double kFeedRounding = 0.5e-3 / 60 * (1 + 1e-6);
constexpr double kFilamentRounding = 1e-5;  // mm: both ends of the sum that E is a difference of

std::string toolpathFromGcodeWritten(const Toolpath& toolpath, const ProgramSettings& settings) {
  std::string text;
  writeGcode(toolpath, Eigen::Isometry3d::Identity(), settings,
             [&](std::string_view piece) { text += piece; });
  return text;
}

void requireSamePath(const Path& read, const Path& original, double volume_per_filament) {
  RC_ASSERT(read.role == original.role);
  RC_ASSERT(read.is_closed == original.is_closed);
  RC_ASSERT(read.process.is_retracted == original.process.is_retracted);
  RC_ASSERT(read.points.size() == original.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    RC_ASSERT((read.points[i] - original.points[i]).cwiseAbs().maxCoeff() <= kPositionRounding);
    if (i == 0 && !read.is_closed) continue;
    RC_ASSERT(std::abs(read.feed_mm_s.at(i) - original.feed_mm_s.at(i)) <= kFeedRounding);
  }
  const double tolerance_mm3 =
      kFilamentRounding * volume_per_filament * (original.bead.isCommon() ? 1.0 : 2.0);
  if (read.bead.isCommon() || !original.bead.isCommon())
    RC_ASSERT(std::abs(depositedVolume(read) - depositedVolume(original)) <= tolerance_mm3);
  if (original.bead.isCommon()) RC_ASSERT(read.bead.isCommon());
}

TEST(ToolpathFromGcode, ReadsBackWhatWasWritten) {
  EXPECT_TRUE(rc::check(
      "the toolpath read back equals the one toolpathFromGcodeWritten within the rounding",
      [](std::uint64_t seed) {
        const Toolpath original = test::randomToolpath(seed);
        validate(original);
        const ProgramSettings settings;
        const Toolpath read =
            toolpathFromGcode(toolpathFromGcodeWritten(original, settings), settings, original.part_name);
        validate(read);
        const double volume_per_filament = M_PI * 0.875 * 0.875;
        RC_ASSERT(read.layers.size() == original.layers.size());
        for (std::size_t l = 0; l < read.layers.size(); ++l) {
          RC_ASSERT(std::abs(read.layers[l].z_mm - original.layers[l].z_mm) <= kPositionRounding);
          RC_ASSERT(std::abs(read.layers[l].height_mm - original.layers[l].height_mm) <= kPositionRounding);
          RC_ASSERT(read.layers[l].paths.size() == original.layers[l].paths.size());
          for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
            requireSamePath(read.layers[l].paths[p], original.layers[l].paths[p], volume_per_filament);
        }
      }));
}

/// 0.05 mm of filament per mm, there and back between -0.0005 and 0.1005 mm, and on to 0.1995 mm: read as
/// motions of 0.1 mm.
TEST(ToolpathFromGcode, RoundingThatStretchesOneOfManyShortMotionsMakesNoOtherWidth) {
  std::string program = "G28\nM83\n;LAYER:0\n;TYPE:FILL\nG0 X0 Y0 Z0.2 F600\n";
  for (int i = 0; i < 19; ++i) program += i % 2 == 0 ? "G1 X0.1 E0.00505\n" : "G1 X0 E0.00505\n";
  program += "G1 X0.2 E0.00495\n";
  program += ";TYPE:WALL-INNER\nG1 X1.2 E0.05\nG1 X1.3 E0.0054\n";
  const Toolpath read = toolpathFromGcode(program, {}, "part");
  const auto& paths = read.layers.at(0).paths;
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_TRUE(paths[1].bead.isCommon());
  EXPECT_FALSE(paths[2].bead.isCommon()) << "0.054 mm per mm is another bead";
}

TEST(ToolpathFromGcode, ReadsBackAShortMotionBesideOthersThatWereShortened) {
  for (const std::uint64_t seed : {56883109U, 13621U, 16538U, 17000U, 19361U}) {
    const Toolpath original = test::randomToolpath(seed);
    const ProgramSettings settings;
    const Toolpath read = toolpathFromGcode(toolpathFromGcodeWritten(original, settings), settings, "part");
    for (std::size_t l = 0; l < read.layers.size(); ++l)
      for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
        EXPECT_TRUE(read.layers[l].paths[p].bead.isCommon() || !original.layers[l].paths[p].bead.isCommon())
            << seed;
  }
}

TEST(ToolpathFromGcode, ReadsEventsAndToolsOfThePart) {
  const Toolpath read = toolpathFromGcode(
      "G28\nM106 S10\nG4 S9\nM83\n;LAYER:0\nM106 S51\nG0 X1 Y1 Z0.2 F600\nT2\n;TYPE:SKIN\nG1 X2 E1\nG4 "
      "P1500\nG1 "
      "X3 E1\n"
      "M106 P1 S255\nM0 insert nuts\nG1 X4 E1\nM107\n; end of the part\nM106 S255\nG4 S7\nT0\n",
      {}, "part");
  const auto& paths = read.layers.at(0).paths;
  ASSERT_EQ(paths.size(), 2U);
  ASSERT_EQ(paths[0].events.size(), 1U);
  EXPECT_EQ(paths[0].tool, 0U);
  EXPECT_DOUBLE_EQ(std::get<FanShare>(paths[0].events[0].event).share, 0.2);
  EXPECT_EQ(paths[1].role, PathRole::Skin);
  EXPECT_EQ(paths[1].tool, 2U);
  ASSERT_EQ(paths[1].events.size(), 2U);
  EXPECT_EQ(paths[1].events[0].motion, 1U);
  EXPECT_DOUBLE_EQ(std::get<Dwell>(paths[1].events[0].event).duration_s, 1.5);
  EXPECT_EQ(paths[1].events[1].motion, 2U);
  EXPECT_EQ(std::get<OperatorPause>(paths[1].events[1].event).message, "insert nuts");
  ASSERT_EQ(read.events_at_end.size(), 1U);
  EXPECT_DOUBLE_EQ(std::get<FanShare>(read.events_at_end[0]).share, 0.0);
}

TEST(ToolpathFromGcode, FindsTheWidthOfABead) {
  for (const Bead bead : {Bead{0.4, 0.2}, Bead{0.2, 0.2}, Bead{0.1, 0.2}, Bead{6.0, 3.0}})
    EXPECT_NEAR(beadWidth(crossSection(bead), bead.height_mm), bead.width_mm, 1e-12);
  EXPECT_EQ(beadWidth(0.0, 0.2), 0.0);
}

// The gap below an overhang leaves the top of a support beside the layer's.
TEST(ToolpathFromGcode, TakesTheHeightOfALayerFromThePart) {
  const Toolpath read = toolpathFromGcode(
      "M83\n;LAYER:0\n;TYPE:SUPPORT-INTERFACE\nG0 X0 Y0 Z0.12 F600\nG1 X5 E1\n"
      ";TYPE:WALL-OUTER\nG0 X0 Y5 Z0.2\nG1 X5 E1\n",
      ProgramSettings{}, "supported");
  ASSERT_EQ(read.layers.size(), 1U);
  EXPECT_DOUBLE_EQ(read.layers[0].z_mm, 0.2);
}

TEST(ToolpathFromGcode, FindsLayersByHeightWithoutComments) {
  const Toolpath toolpath =
      toolpathFromGcode("G28\nM83\nG1 X5 Z0.2 F3000\nG1 X10 E1\nG1 Z0.5\nG1 X20\nG1 X30 E1\nG1 Y5 E1\n",
                        ProgramSettings{}, "lines");
  ASSERT_EQ(toolpath.layers.size(), 2U);
  EXPECT_DOUBLE_EQ(toolpath.layers[0].z_mm, 0.2);
  EXPECT_NEAR(toolpath.layers[1].height_mm, 0.3, 1e-12);
  ASSERT_EQ(toolpath.layers[1].paths.size(), 2U);
  EXPECT_EQ(toolpath.layers[1].paths[0].role, PathRole::Travel);
  EXPECT_EQ(toolpath.layers[1].paths[1].points.size(), 3U);
}

TEST(ToolpathFromGcode, ReadsTheCommentsOfCura) {
  const Toolpath toolpath = toolpathFromGcode(
      "G28\n;Layer height: 0.3\nG1 Z15 F6000\n;LAYER:0\nG0 F3600 X1 Z0.3\n;TYPE:WALL-OUTER\nG1 F1800 X9 E1\n"
      "G1 E-5\nG0 X20\nG1 E1\n;TYPE:FILL\nG1 X30 E2\n",
      ProgramSettings{}, "cura");
  ASSERT_EQ(toolpath.layers.size(), 1U);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 4U);
  EXPECT_EQ(paths[1].role, PathRole::OuterWall);
  EXPECT_DOUBLE_EQ(paths[1].bead.at(0).height_mm, 0.3);
  EXPECT_TRUE(paths[2].process.is_retracted);
  EXPECT_EQ(paths[3].role, PathRole::Infill);
  EXPECT_DOUBLE_EQ(paths[3].feed_mm_s.at(1), 30.0);
}

TEST(ToolpathFromGcode, ReadsTheCommentsOfPrusaSlicer) {
  const Toolpath toolpath = toolpathFromGcode(
      "M83\n;TYPE:Custom\nG1 Z5 F5000\n;LAYER_CHANGE\n;Z:0.35\n;HEIGHT:0.35\nG1 Z.35\n;TYPE:External "
      "perimeter\n"
      "G1 X9 E1\n;LAYER_CHANGE\n;Z:0.55\n;HEIGHT:0.2\nG1 Z.55\n;TYPE:Gap fill\nG1 X20 E1\n",
      ProgramSettings{}, "prusa");
  ASSERT_EQ(toolpath.layers.size(), 2U);
  EXPECT_DOUBLE_EQ(toolpath.layers[0].height_mm, 0.35);
  EXPECT_EQ(toolpath.layers[0].paths.back().role, PathRole::OuterWall);
  EXPECT_DOUBLE_EQ(toolpath.layers[1].height_mm, 0.2);
  EXPECT_EQ(toolpath.layers[1].paths.back().role, PathRole::GapFill);
}

TEST(ToolpathFromGcode, ReadsTheCommentsOfSlic3r) {
  const Toolpath toolpath = toolpathFromGcode(
      "G1 Z5 F5000\nG1 Z0.4 ; move to next layer (0)\nG1 X1 E1 ; skirt\nG1 X2\nG1 X3 E2 ; perimeter\n",
      ProgramSettings{}, "slic3r");
  ASSERT_EQ(toolpath.layers.size(), 1U);
  EXPECT_EQ(toolpath.layers[0].paths[1].role, PathRole::Skirt);
  EXPECT_EQ(toolpath.layers[0].paths.back().role, PathRole::InnerWall);
}

TEST(ToolpathFromGcode, JoinsLayersAcrossWhatIsLeftOut) {
  const Toolpath toolpath = toolpathFromGcode(
      "M83\n;LAYER:0\nG1 X9 E1\n; end of the part\nG1 Y50\n;LAYER:1\nG1 X1 E1\nG28\nG1 X7 E1\n",
      ProgramSettings{}, "gap");
  EXPECT_NO_THROW(validate(toolpath));
  ASSERT_EQ(toolpath.layers.size(), 2U);
  EXPECT_EQ(toolpath.layers[1].paths[0].role, PathRole::Travel);
}

/// Where a machine that has not homed comes from, nobody knows.
TEST(ToolpathFromGcode, BeginsWhereTheProgramFirstStatesAPlace) {
  const std::string print = "G0 X200 Y180\nG0 Z0.2\nG1 X210 E1\nG0 X220\nG1 Y190 E1\n";
  const Toolpath unhomed = toolpathFromGcode("M83\n" + print, {}, "print");
  ASSERT_EQ(unhomed.layers.size(), 1U);
  const auto& paths = unhomed.layers[0].paths;
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_NE(paths[0].role, PathRole::Travel);
  EXPECT_EQ(paths[0].points.front(), Point3(200, 180, 0.2));
  EXPECT_EQ(paths[1].role, PathRole::Travel);
  for (const char* start : {"G28\n", "G92 X0 Y0 Z0\n", "G0 X0 Y0 Z0\n"}) {
    const Toolpath stated = toolpathFromGcode(std::string(start) + "M83\n" + print, {}, "print");
    EXPECT_EQ(stated.layers.at(0).paths.size(), 4U) << start;
    EXPECT_EQ(stated.layers.at(0).paths.at(0).points.front(), Point3(0, 0, 0)) << start;
  }
}

TEST(ToolpathFromGcode, RefusesAProgramWithoutMotion) {
  EXPECT_THROW(toolpathFromGcode("M104 S200\n", ProgramSettings{}, "heat"), InvalidProgram);
  EXPECT_THROW(toolpathFromGcodeFile("/nonexistent/part.gcode", ProgramSettings{}), FileError);
}

}  // namespace
}  // namespace lamina
