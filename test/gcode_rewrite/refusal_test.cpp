// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::contains;
using test::transformed;
using test::withHeight;

/// What is said against a line within the part: the fifth of the program.
std::string refusalOf(const std::string& lines) {
  try {
    transformed("M83\n;LAYER:0\nG0 X0 Y0 Z0\nG1 X1 E1\n" + lines + "\nG1 X2 E1\n", withHeight(0.2));
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Refusal, WhatCannotBeTransformedNamesItsLine) {
  for (const std::string bad : {"G92 X0",      "G92",          "G5 X1 Y1",       "G10 P1 X5",
                                "G29",         "G54",          "G38.2 Z1",       "X5 Y5",
                                "E4",          "G1 X1 X2",     "G1 X",           "G1 X1.2.3",
                                "G1 X1 A5",    "G1 H2 X1",     "G1 R1 X1",       "G1 X5*33",
                                "G1 X1 G0 Y2", "G1 X1 (open",  "G1 X1 #5",       "G1 X99999999",
                                "M206 X1",     "M98 P\"a.g\"", "M32 a.g",        "M290 S0.1",
                                "M851 Z-1",    "G2 X5 Y0",     "G2 X5 Y5 I9 J0", "G3 X5 R1",
                                "G2 X5 I2 P2"})
    EXPECT_EQ(refusalOf(bad).substr(0, 8), "line 5: ") << bad << ": " << refusalOf(bad);
}

TEST(Refusal, ModesThatChangeTheMeaningOfMotionsNameTheMotion) {
  EXPECT_EQ(refusalOf("G91\nG1 X1").substr(0, 8), "line 6: ");
  EXPECT_EQ(refusalOf("G20\nG1 X1").substr(0, 8), "line 6: ");
  EXPECT_EQ(refusalOf("G91\nG1 E-1 F99\nG90\nM83"), "nothing");
}

TEST(Refusal, ExtrusionThatFirmwaresReadDifferentlyIsNotGuessed) {
  EXPECT_EQ(refusalOf("G90").substr(0, 8), "line 6: ");
  EXPECT_EQ(refusalOf("G90\nM83"), "nothing");
}

TEST(Refusal, ADepositionFromAnUnknownPlaceIsNotGuessed) {
  EXPECT_THROW(transformed("M83\nG0 X0 Y0 Z0\n;LAYER:0\nG1 X1 E1\n", withHeight(0.2)), InvalidProgram);
  EXPECT_THROW(transformed("M83\nG0 X0 Y0 Z0\n;LAYER:0\nG1 X1 Y2 Z3 E1\n", withHeight(0.2)), InvalidProgram);
}

TEST(Refusal, RelativeExtrusionThatIsNotSaidIsNotTakenForAbsolute) {
  const std::string program = test::publishedExample().substr(4);
  EXPECT_THROW(transformed(program, withHeight(1.5)), InvalidProgram);
  RewriteSettings settings = withHeight(1.5);
  settings.initial_extrusion = ExtrusionMode::Relative;
  EXPECT_EQ("M83\n" + transformed("G90\n" + program, settings).text.substr(4),
            transformed(test::publishedExample(), withHeight(1.5)).text);
}

Unreachable unreachable(const std::string& program, const RewriteSettings& settings) {
  try {
    transformed(program, settings);
  } catch (const Unreachable& error) {
    return error;
  }
  return Unreachable("reached");
}

TEST(Refusal, WhatLeavesTheMachineNamesLineAxisAndValue) {
  // (1300, 2500, 1000) comes to (1300, 1060.66, 2474.87).
  RewriteSettings settings = test::asSliced();
  settings.limits_mm = Box3{Point3::Zero(), Point3(1300.0, 2500.0, 1000.0)};
  const std::string what = unreachable("M83\n;LAYER:0\nG0 X1300 Y2400 Z1000\nG1 Y2500 E1\n", settings).what();
  EXPECT_EQ(what.substr(0, 49), "line 4: the nozzle would be at z = 2474.874 mm; m") << what;
  settings.limits_mm->high.z() = 2475.0;
  EXPECT_NO_THROW(transformed("M83\n;LAYER:0\nG0 X1300 Y2400 Z1000\nG1 Y2500 E1\n", settings));
}

TEST(Refusal, AFinalPositionOutOfTheMachineIsRefused) {
  RewriteSettings settings = withHeight(0.2);
  settings.limits_mm = Box3{Point3::Zero(), Point3::Constant(100.0)};
  settings.final_position_mm = Point3(0.0, 0.0, 101.0);
  const std::string what = unreachable("M83\n;LAYER:0\nG0 X1 Y1 Z0\nG1 X2 E1\n", settings).what();
  EXPECT_TRUE(contains(what, "final position is z = 101.000 mm")) << what;
}

TEST(Refusal, SettingsOutOfBoundsAreNamed) {
  RewriteSettings settings;
  settings.decimals = 7;
  EXPECT_THROW(validate(settings), InvalidConfig);
  settings = withHeight(0.0);
  EXPECT_THROW(validate(settings), InvalidConfig);
  settings = {};
  settings.table_position_mm = Point2(1.0, 1.0);
  settings.offset_mm.x() = 1.0;
  EXPECT_THROW(validate(settings), InvalidConfig);
}

/// A file in a folder of its own, and what a transform of it throws.
class RefusedFile : public testing::Test {
 protected:
  void SetUp() override { writeFile(input(), kProgram); }
  std::string input() const { return folder_.file("part.gcode"); }
  void run(const std::string& output, Progress& progress) {
    rewriteProgram({input(), output}, {map_}, withHeight(0.2), progress);
  }
  void expectSourceOnly() const {
    EXPECT_EQ(readFile(input()), kProgram);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.file("")), {}), 1);
  }

  const std::string kProgram = "M83\n;LAYER:0\nG0 X0 Y0 Z0\nG1 X1 E1\n";
  const test::ScratchFolder folder_;
  const AffineMap map_ = test::aboutX45();
  NoProgress progress_;
};

TEST_F(RefusedFile, IsNeverOverwritten) {
  EXPECT_THROW(run(input(), progress_), InvalidInput);
  expectSourceOnly();
}

TEST_F(RefusedFile, LeavesNothingWhereNothingCanBeWritten) {
  EXPECT_THROW(run(folder_.file("none/out.gcode"), progress_), FileError);
  expectSourceOnly();
}

TEST_F(RefusedFile, MustBeThere) {
  EXPECT_THROW(rewriteProgram({folder_.file("none.gcode"), folder_.file("out.gcode")}, {map_},
                              withHeight(0.2), progress_),
               FileError);
  expectSourceOnly();
}

TEST_F(RefusedFile, MustStayAsItIs) {
  struct Appending final : Progress {
    explicit Appending(std::string path) : file(std::move(path)) {}
    void report(const std::string& stage, double) override {
      if (stage == "measure") std::ofstream(file, std::ios::app) << "G1 X5 E1\n";
    }
    bool isCancelled() const override { return false; }
    std::string file;
  } progress(input());
  EXPECT_THROW(run(folder_.file("out.gcode"), progress), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("out.gcode")));
}

TEST_F(RefusedFile, LeavesNothingWhenCancelled) {
  struct CancelledWhileWriting final : Progress {
    void report(const std::string& stage, double) override { is_measured = stage == "measure"; }
    bool isCancelled() const override { return is_measured; }
    bool is_measured = false;
  } progress;
  EXPECT_THROW(run(folder_.file("out.gcode"), progress), Cancelled);
  expectSourceOnly();
}

}  // namespace
}  // namespace lamina
