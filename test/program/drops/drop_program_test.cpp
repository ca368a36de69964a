// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/drops/drop_program.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "support/drop_programs.hpp"

namespace lamina {
namespace {

using test::kDropHeader;
using test::kNoneMissing;
using test::squareProgram;

DropProgram parse(const std::string& text) { return parseDropProgram(text, {}); }

std::string refusal(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const InvalidProgram& error) {
    return error.what();
  }
}

TEST(DropProgram, HoldsHeaderAndDropsOfEachLayer) {
  const DropProgram program = parse(squareProgram({kNoneMissing, {4, 4}}));
  EXPECT_EQ(program.diameter_mm, 1.0);
  EXPECT_EQ(program.layer_height_mm, 1.0);
  EXPECT_EQ(program.strategy, "drops_raster");
  ASSERT_EQ(program.layers.size(), 2U);
  EXPECT_EQ(program.layers[0].drops.size(), 81U);
  EXPECT_EQ(program.layers[1].drops.size(), 80U);
  const ProgramDrop& first = program.layers[1].drops.front();
  EXPECT_EQ(first.position, Point3(10, 20, 2));
  EXPECT_EQ(first.role, PathRole::OuterWall);
  EXPECT_EQ(first.command, "M780 P3");
  EXPECT_DOUBLE_EQ(first.feed_mm_s, 10.0);
  EXPECT_EQ(program.layers[1].drops.back().role, PathRole::Infill);
}

TEST(DropProgram, TakesCoordinatesThatHoldOn) {
  const DropProgram program =
      parse(kDropHeader + ";LAYER:0\nG1 X1 Y2 Z3\nM780\nX4\nM780\nG91\nG1 Y1\nM780\nM780\n");
  ASSERT_EQ(program.layers.size(), 1U);
  const std::vector<Point3> expected = {{1, 2, 3}, {4, 2, 3}, {4, 3, 3}, {4, 3, 3}};
  ASSERT_EQ(program.layers[0].drops.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(program.layers[0].drops[i].position.isApprox(expected[i])) << i;
}

TEST(DropProgram, WithoutLayerMarksBeginsALayerAtEachHeight) {
  const DropProgram program =
      parse("G1 X0 Y0 Z1 F600\nM780\nG1 X1\nM780\nG1 Z5\nG1 X2 Z2\nM780\nG1 X3\nM780\n");
  ASSERT_EQ(program.layers.size(), 2U) << "a lift between drops is no layer";
  EXPECT_EQ(program.layers[0].drops.size(), 2U);
  EXPECT_EQ(program.layers[1].drops.size(), 2U);
  EXPECT_FALSE(program.layers[0].drops[0].role.has_value());
}

TEST(DropProgram, LeavesDropsBeforeThePartAndBehindItAlone) {
  const DropProgram program =
      parse(kDropHeader + "G1 X5\nM780\n;LAYER:0\nG1 X1 Y1 Z1\nM780\n" + ";end of the part\nG1 X9\nM780\n");
  ASSERT_EQ(program.layers.size(), 1U);
  EXPECT_EQ(program.layers[0].drops.size(), 1U);
}

TEST(DropProgram, SpeaksTheWordsOfItsDialect) {
  DropDialect dialect;
  dialect.discharge = "M42 P1";
  dialect.layer_mark = "SLICE ";
  dialect.role_mark = "ROLE ";
  dialect.contour = "rim";
  dialect.diameter_key = "d";
  const DropProgram program =
      parseDropProgram("; d=0.25\n; SLICE 0\nG1 X1 Y1 Z1 F60\n; ROLE rim\nM42 P1\n", dialect);
  ASSERT_EQ(program.layers.size(), 1U);
  EXPECT_EQ(program.diameter_mm, 0.25);
  EXPECT_EQ(program.layers[0].drops[0].role, PathRole::OuterWall);
}

TEST(DropProgram, IsReportedFromOneOfBeadsByHeaderOrDischarge) {
  EXPECT_TRUE(isDropProgram(";drop_diameter=1\nG1 X0\n", {}));
  EXPECT_TRUE(isDropProgram("G1 X1 F60\nM780 ; let go\n", {}));
  EXPECT_TRUE(isDropProgram("M780", {}));
  EXPECT_FALSE(isDropProgram("G1 X1 E1\n; M780 is no command here\nM7801\nM117 M780\n", {}));
}

TEST(DropProgram, RefusesHeadersThatReportNoSizeAndNamesTheLine) {
  EXPECT_NE(refusal(";units=mm\n;drop_diameter=0\n").find("line 2"), std::string::npos);
  for (const char* bad : {"0", "-1", "wide", "inf", "nan", "1e9"})
    EXPECT_NE(refusal(std::string(";drop_diameter=") + bad + "\n"), "") << bad;
  EXPECT_NE(refusal(";units=inch\n").find("must be mm"), std::string::npos);
}

TEST(DropProgram, RefusesADropOfWhichNobodyKnowsWhereItFalls) {
  EXPECT_NE(refusal("M780\n").find("line 1"), std::string::npos);
  EXPECT_NE(refusal("G1 X1 F60\nG28\nM780\n").find("line 3"), std::string::npos);
}

TEST(DropProgram, BecomesAToolpathOfRunsOfOneRole) {
  const Toolpath toolpath = toolpathFromGcode(squareProgram({{4, 4}}), {}, "square");
  ASSERT_EQ(toolpath.layers.size(), 1U);
  EXPECT_DOUBLE_EQ(toolpath.layers[0].height_mm, 1.0);
  std::vector<std::pair<PathRole, std::size_t>> runs;
  for (const Path& path : toolpath.layers[0].paths)
    if (path.role != PathRole::Travel) {
      EXPECT_EQ(path.deposit, Deposit::Drops);
      EXPECT_DOUBLE_EQ(path.bead.at(0).width_mm, 1.0);
      runs.emplace_back(path.role, path.points.size());
    }
  EXPECT_EQ(runs, (std::vector<std::pair<PathRole, std::size_t>>{{PathRole::OuterWall, 32},
                                                                 {PathRole::Infill, 48}}));
  EXPECT_NO_THROW(validate(toolpath));
}

TEST(DropProgram, WithoutAHeaderIsNoToolpath) {
  EXPECT_THROW(toolpathFromGcode("G1 X1 Y1 Z1 F60\nM780\n", {}, "drops"), InvalidProgram);
}

}  // namespace
}  // namespace lamina
