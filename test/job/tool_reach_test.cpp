// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/job/plate/plate_job.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// A box of 20 mm in the middle of a bed of 220 mm, whose infill another tool lays.
std::string refusalWith(const std::string& offset_mm, const std::vector<SettingText>& more = {}) {
  std::vector<SettingText> set = {{"tools.list", "[{name: a}, {name: b, offset_mm: [" + offset_mm + "]}]"},
                                  {"tool.infill", "1"}};
  set.insert(set.end(), more.begin(), more.end());
  NoProgress nobody;
  try {
    runSliceJob({"box", "", loadJobSettings("", set)}, nobody);
    return "";
  } catch (const Unreachable& error) {
    return error.what();
  }
}

TEST(ToolReach, CountsHowFarTheTipIsFromThatOfTheFirstTool) {
  EXPECT_EQ(refusalWith("30, 0, 0"), "");
  const std::string beyond = refusalWith("300, 0, 0");
  EXPECT_NE(beyond.find("with the offset of tool 1, axis x would be at -"), std::string::npos) << beyond;
  EXPECT_NE(beyond.find("reaches 0.000 to 220.000 mm"), std::string::npos) << beyond;
  const std::string above = refusalWith("0, 0, -260");
  EXPECT_NE(above.find("with the offset of tool 1, axis z would be at 26"), std::string::npos) << above;
}

/// Where nobody states the tools, `lamina check` takes them from the program.
TEST(ToolReach, OffsetsStandInTheHeadOfAProgram) {
  const test::ScratchFolder folder;
  const std::string program = folder.file("box.gcode");
  NoProgress nobody;
  const std::vector<SettingText> set = {{"tools.list", "[{name: a}, {name: b, offset_mm: [30, -0.5, 0.1]}]"},
                                        {"tool.infill", "1"}};
  runSliceJob({"box", program, loadJobSettings("", set)}, nobody);
  EXPECT_EQ(toolOffsetsIn(program), (std::vector<Point3>{Point3::Zero(), Point3(30, -0.5, 0.1)}));
  runSliceJob({"box", program, loadJobSettings("", {})}, nobody);
  EXPECT_TRUE(toolOffsetsIn(program).empty());
  EXPECT_TRUE(toolOffsetsIn("box.csv").empty()) << "not read";
}

/// Walls begin 100.2 mm from the edge of the bed, and leads of 8 mm before them.
TEST(ToolReach, IsCheckedAnewWhereRunsAreChanged) {
  const SettingText walls = {"tool.walls", "1"};
  const SettingText no_skirt = {"skirt.count", "0"};
  EXPECT_EQ(refusalWith("100, 0, 0", {walls, no_skirt}), "");
  const std::string refusal = refusalWith(
      "100, 0, 0", {walls, no_skirt, {"lead.in", "line"}, {"lead.length_mm", "8"}, {"lead.angle_deg", "0"}});
  EXPECT_NE(refusal.find("with the offset of tool 1, axis x would be at -7.800 mm"), std::string::npos)
      << refusal;
}

/// Tool 0 reaches from 0 to 220 mm, and tool 1 from 100 mm on.
TEST(ToolReach, PartsOfAPlateStandWhereAllToolsReach) {
  const std::vector<SettingText> set = {{"tools.list", "[{name: a}, {name: b, offset_mm: [100, 0, 0]}]"},
                                        {"tool.infill", "1"},
                                        {"skirt.count", "0"}};
  PlateJob job;
  job.settings = loadJobSettings("", set);
  job.plate.parts.resize(8);
  for (PlatePart& part : job.plate.parts) part.file = "box";
  NoProgress nobody;
  for (const PlatedPart& part : runPlateJob(job, nobody).parts) {
    EXPECT_GE(part.at_mm.x(), 110.0 - 1e-6);
    EXPECT_LE(part.at_mm.x(), 210.0 + 1e-6);
  }
}

}  // namespace
}  // namespace lamina
