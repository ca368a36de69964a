// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::transformed;

const std::string kPart = ";LAYER:0\nG0 X0 Y0 Z0\nG1 X1 E1\n; end of the part\n";
const std::string kRotated =
    ";LAYER:0\nG0 X0.000 Y0.000 Z0.200\nG1 X1.000 Y0.000 Z0.200 E1\n; end of the part\n";

TEST(InsertedCode, StandsAfterTheHeadAndAtTheEnd) {
  RewriteSettings settings = test::withHeight(0.2);
  settings.begin_code = "M117 begin\nG28";
  settings.end_code = "M117 end\n";
  EXPECT_EQ(
      transformed(";FLAVOR:Marlin\n\n;TIME:1\nM83\nM104 S9 ;heat\n" + kPart + "M104 S0\n", settings).text,
      ";FLAVOR:Marlin\n;TIME:1\nM117 begin\nG28\nM83\nM104 S9 ;heat\n" + kRotated + "M104 S0\nM117 end\n");
}

TEST(InsertedCode, StandsBeforeThePartIfThereIsNoStartCode) {
  RewriteSettings settings = test::withHeight(0.2);
  settings.begin_code = "M83\n";
  EXPECT_EQ(transformed(";head\n" + kPart, settings).text, ";head\nM83\n" + kRotated);
}

TEST(InsertedCode, CountsForTheModesOfThePart) {
  RewriteSettings settings = test::withHeight(0.2);
  settings.begin_code = "M83\nG91\n";
  EXPECT_THROW(transformed(kPart, settings), InvalidProgram);
  settings.begin_code = "G92 X0\n";
  EXPECT_THROW(transformed("M83\n" + kPart, settings), InvalidProgram);
  settings.begin_code = ";LAYER:0\n";
  EXPECT_THROW(transformed("M83\n" + kPart, settings), InvalidProgram);
}

TEST(InsertedCode, TheFinalMoveGoesOverThePartWhileMotorsHold) {
  RewriteSettings settings = test::withHeight(0.2);
  settings.final_position_mm = Point3(10.0, 20.0, 0.1);
  settings.final_feed_mm_min = 1200.0;
  settings.end_code = "M117 end";
  EXPECT_EQ(
      transformed("M83\n" + kPart + "M104 S0\nM84\nM2\n", settings).text,
      "M83\n" + kRotated + "M104 S0\nG0 F1200 Z0.200\nG0 X10.000 Y20.000\nG0 Z0.100\nM84\nM117 end\nM2\n");
}

TEST(InsertedCode, TheFinalMoveIsInMillimetresAndAbsoluteWhateverTheEndCodeSays) {
  RewriteSettings settings = test::withHeight(0.2);
  settings.final_position_mm = Point3(10.0, 20.0, 300.0);
  EXPECT_EQ(
      transformed("M83\n" + kPart + "G91\nG20\n", settings).text,
      "M83\n" + kRotated + "G91\nG20\nG21\nG90\nG0 F3000 Z300.000\nG0 X10.000 Y20.000\nG20\nG91\nM83\n");
}

}  // namespace
}  // namespace lamina
