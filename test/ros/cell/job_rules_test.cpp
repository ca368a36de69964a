// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/cell_controller/job_rules.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/job/program_check.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

std::string csvOf(const Toolpath& toolpath) {
  std::string csv;
  writeCsv(toolpath, [&csv](std::string_view piece) { csv += piece; });
  return csv;
}

CellControllerSettings cellWith(ExecutorKind executor, const std::string& machine) {
  CellControllerSettings settings;
  settings.executor = executor;
  settings.machine.name = machine;
  return settings;
}

/// Layers, or why the job is refused.
std::string takenBy(const CellControllerSettings& settings, const std::string& text) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/3fa1";
  writeFile(path, text);
  NoProgress nobody;
  try {
    return std::to_string(checkedLayers(path, "bracket.gcode", settings, nobody));
  } catch (const Error& error) {
    return error.what();
  }
}

bool isIn(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(JobRules, TakeWhatTheExecutorRuns) {
  const std::string toolpath = csvOf(test::twoLayers());
  const std::string program = ";LAYER:0\nM83\nG1 X50 Y50 Z0.2 F6000\nG1 X60 E1\n";
  EXPECT_EQ(takenBy(cellWith(ExecutorKind::Stream, "cartesian_gantry"), program), "1");
  EXPECT_EQ(takenBy(cellWith(ExecutorKind::Driver, "irb_4600"), toolpath), "2");
  const std::string refused = takenBy(cellWith(ExecutorKind::Driver, "irb_4600"), program);
  EXPECT_TRUE(isIn(refused, "line 1 is ';LAYER:0'; expected the header of a toolpath")) << refused;
  const std::string no_program = takenBy(cellWith(ExecutorKind::Stream, "cartesian_gantry"), toolpath);
  EXPECT_TRUE(isIn(no_program, "line 2: a letter is expected")) << no_program;
}

TEST(JobRules, NameTheFileAsItWasSent) {
  const CellControllerSettings printer = cellWith(ExecutorKind::Stream, "cartesian_gantry");
  EXPECT_EQ(takenBy(printer, "G28\n"),
            "bracket.gcode: extrudes nothing; expected a program that prints a part");
  const std::string binary = takenBy(printer, std::string("GCDE\x01\x00\x00\x00", 8));
  EXPECT_TRUE(isIn(binary, "cannot read 'bracket.gcode': it is binary G-code")) << binary;
}

TEST(JobRules, RefuseWhatTheDriverWouldRefuseAtTheStart) {
  const CellControllerSettings robot = cellWith(ExecutorKind::Driver, "irb_4600");
  const std::string empty = takenBy(robot, csvOf(Toolpath{"empty", {}}));
  EXPECT_TRUE(isIn(empty, "station")) << empty;
  Toolpath drops = test::twoLayers();
  for (ToolpathLayer& layer : drops.layers)
    for (Path& path : layer.paths) path.deposit = Deposit::Drops;
  const std::string dropped = takenBy(robot, csvOf(drops));
  EXPECT_TRUE(isIn(dropped, "drop")) << dropped;
}

TEST(JobRules, LookForCollisionsUnlessTheyAreOfNoConcern) {
  const Toolpath beneath{"beneath", {{0.2, 0.2, {test::straightPath({0, 0, -40}, {20, 0, -40})}}}};
  CellControllerSettings robot = cellWith(ExecutorKind::Driver, "irb_4600");
  robot.placement = Placement::AsIs;
  EXPECT_NE(takenBy(robot, csvOf(beneath)), "1") << "the tool in the bed";
  robot.drive.clearance.need = ClearanceNeed::Never;
  EXPECT_EQ(takenBy(robot, csvOf(beneath)), "1");
}

TEST(JobRules, CheckAToolpathWholeForItsMachine) {
  const Toolpath far{"far", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {9000, 0, 0.2})}}}};
  const std::string refused = takenBy(cellWith(ExecutorKind::Driver, "irb_4600"), csvOf(far));
  EXPECT_TRUE(isIn(refused, "layer 0")) << refused;
  CellControllerSettings as_is = cellWith(ExecutorKind::Driver, "irb_4600");
  as_is.placement = Placement::AsIs;
  const Toolpath under{"under", {{0.2, 0.2, {test::straightPath({0, 0, -60}, {10, 0, -60})}}}};
  const std::string collides = takenBy(as_is, csvOf(under));
  EXPECT_TRUE(isIn(collides, "collision")) << collides;
  EXPECT_EQ(takenBy(cellWith(ExecutorKind::Driver, "irb_4600"), csvOf(under)), "1")
      << "over the middle of the bed it stands on it";
}

// A job that is checked for one executor, or one place, is not started on another.
TEST(JobRules, StateWhatAJobIsCheckedFor) {
  const CellControllerSettings stream = cellWith(ExecutorKind::Stream, "irb_4600");
  CellControllerSettings driver = cellWith(ExecutorKind::Driver, "irb_4600");
  EXPECT_EQ(jobSheet(stream), machineSheet(stream.machine)) << "jobs of earlier versions have these bytes";
  EXPECT_EQ(jobSheet(driver),
            machineSheet(driver.machine) + "executor: trajectory_driver\nplacement: centre\n");
  driver.placement = Placement::AsIs;
  EXPECT_TRUE(isIn(jobSheet(driver), "\nplacement: as_is\n"));
}

}  // namespace
}  // namespace lamina
