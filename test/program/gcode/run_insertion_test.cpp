// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/run_insertion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

namespace lamina {
namespace {

const std::string kAbsolute =
    "; a program with absolute filament\nG21\nG90\nM82\nG92 E0\n"
    ";LAYER:0\n;HEIGHT:0.2\n;TYPE:outer_wall\nG0 X0 Y0 Z0.2 F6000\nG1 X10 E0.5 F1800\nG1 Y10 E1.0\nM117 "
    "layer done\n"
    ";LAYER:1\n;TYPE:outer_wall\nG0 X0 Y0 Z0.4 F6000\nG1 X10 E1.5 F1800\nY10 E2.0\nG1 E1.2 F2100\n"
    ";end of the part\nM84\n";

Toolpath read(const std::string& program) { return toolpathFromGcode(program, {}, "test"); }

Path bead(double z) {
  Path path;
  path.role = PathRole::GapFill;
  path.points = {{2, 2, z}, {6, 2, z}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  return path;
}

/// Takes the blocks out again.
std::string runInsertionWithoutBlocks(std::string program) {
  const std::string end = ";end of void fill\n";
  for (std::size_t at = program.find(";void fill\n"); at != std::string::npos;
       at = program.find(";void fill\n"))
    program.erase(at, program.find(end, at) + end.size() - at);
  return program;
}

double volume(const Toolpath& toolpath) { return totals(toolpath).deposited_mm3; }

TEST(RunInsertion, OfNoRunGivesTheProgramByteForByte) {
  EXPECT_EQ(insertRuns(kAbsolute, read(kAbsolute), {{}, {}}, {}), kAbsolute);
}

TEST(RunInsertion, KeepsEveryLineOfTheProgram) {
  const std::string filled = insertRuns(kAbsolute, read(kAbsolute), {{bead(0.2)}, {bead(0.4)}}, {});
  EXPECT_GT(filled.size(), kAbsolute.size());
  EXPECT_EQ(runInsertionWithoutBlocks(filled), kAbsolute);
}

TEST(RunInsertion, ReportsTheHeightOfTheRunAndThatOfTheBeadsAfterIt) {
  const std::string program =
      "M83\n;LAYER:0\n;HEIGHT:0.2\n;TYPE:outer_wall\nG0 X0 Y0 Z0.2 F6000\nG1 X10 E0.5 F1800\n;HEIGHT:0.1\n"
      "G1 Y10 E0.5\n;LAYER:1\nG1 Z0.4\nG1 X20 E0.5\n";
  const Toolpath after = read(insertRuns(program, read(program), {{bead(0.2)}, {}}, {}));
  for (const Path& path : after.layers[0].paths) {
    if (path.role != PathRole::GapFill) continue;
    EXPECT_NEAR(path.bead.at(1).height_mm, 0.2, 1e-9);
    EXPECT_NEAR(depositedVolume(path), depositedVolume(bead(0.2)), 1e-4);
  }
  EXPECT_NEAR(after.layers[1].paths.back().bead.at(1).height_mm, 0.1, 1e-9);
}

TEST(RunInsertion, AddsTheRunToItsLayerAndNoOther) {
  const Toolpath before = read(kAbsolute);
  const Toolpath after = read(insertRuns(kAbsolute, before, {{bead(0.2)}, {}}, {}));
  ASSERT_EQ(after.layers.size(), 2U);
  int found = 0;
  for (const Path& path : after.layers[0].paths) {
    if (path.role != PathRole::GapFill) continue;
    ++found;
    EXPECT_NEAR(length(path), 4.0, 1e-9);
    EXPECT_NEAR(path.bead.at(1).width_mm, 0.4, 1e-3);
  }
  EXPECT_EQ(found, 1);
  EXPECT_NEAR(volume(after) - volume(before), depositedVolume(bead(0.2)), 1e-4);
  ASSERT_EQ(after.layers[1].paths.size(), before.layers[1].paths.size());
  EXPECT_EQ(after.layers[1].paths.back().points, before.layers[1].paths.back().points);
}

TEST(RunInsertion, RestoresFilamentFeedAndRole) {
  const std::string filled = insertRuns(kAbsolute, read(kAbsolute), {{bead(0.2)}, {}}, {});
  const std::size_t block =
      filled.find("M82\nG92 E1\nG1 F1800\n;TYPE:outer_wall\n;end of void fill\nM117 layer");
  EXPECT_NE(block, std::string::npos) << filled;
}

TEST(RunInsertion, LeavesRelativeFilamentRelative) {
  std::string relative = kAbsolute;
  relative.replace(relative.find("M82"), 3, "M83");
  const std::string filled = insertRuns(relative, read(relative), {{bead(0.2)}, {}}, {});
  EXPECT_EQ(filled.find("G92 E1"), std::string::npos);
  EXPECT_NEAR(volume(read(filled)) - volume(read(relative)), depositedVolume(bead(0.2)), 1e-4);
}

TEST(RunInsertion, HopsOnLongTravelsAndOnThoseAlone) {
  InsertionSettings settings;
  settings.hop_mm = 0.3;
  Path beside = bead(0.2);  // begins a millimetre from where the first run ends
  beside.points = {{6, 3, 0.2}, {2, 3, 0.2}};
  const Toolpath after = read(insertRuns(kAbsolute, read(kAbsolute), {{bead(0.2), beside}, {}}, settings));
  std::vector<double> tops;
  for (const Path& path : after.layers[0].paths) {
    if (path.role != PathRole::Travel) continue;
    tops.push_back(0.0);
    for (const Point3& point : path.points) tops.back() = std::max(tops.back(), point.z());
  }
  ASSERT_GE(tops.size(), 3U);
  EXPECT_NEAR(tops[tops.size() - 3], 0.5, 1e-9);
  EXPECT_NEAR(tops[tops.size() - 2], 0.2, 1e-9);
  EXPECT_NEAR(tops[tops.size() - 1], 0.5, 1e-9);
}

TEST(RunInsertion, GoesBackToWhereTheProgramLeftOff) {
  const Toolpath before = read(kAbsolute);
  const Toolpath after = read(insertRuns(kAbsolute, before, {{bead(0.2)}, {}}, {}));
  EXPECT_EQ(after.layers[0].paths.back().lastPoint(), before.layers[0].paths.back().lastPoint());
}

TEST(RunInsertion, RefusesWhatItCannotRestore) {
  for (const std::string line : {"G20", "G91", "G92 X1"}) {
    const std::string program = ";LAYER:0\n" + line + "\nG0 X1 Y1 Z0.2 F600\nG1 X10 E0.5\n";
    EXPECT_THROW(insertRuns(program, read(program), {{bead(0.2)}}, {}), InvalidProgram) << line;
  }
  EXPECT_THROW(insertRuns(kAbsolute, read(kAbsolute), {{bead(0.2)}}, {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
