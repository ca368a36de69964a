// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "support/scoped_entry.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

Toolpath oneLine() {
  Path line;
  line.role = PathRole::Infill;
  line.points = {{0, 0, 0.2}, {5, 0, 0.2}};
  line.bead = Bead{0.4, 0.2};
  line.feed_mm_s = 50.0;
  Toolpath toolpath;
  toolpath.part_name = "line";
  toolpath.layers = {{0.2, 0.2, {line}}};
  return toolpath;
}

TEST(OutputWriter, IsChosenByTheSuffix) {
  const test::ScratchFolder folder;
  const Toolpath toolpath = oneLine();
  const Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  for (const std::string& suffix : outputSuffixes()) {
    const std::string path = folder.file("a" + suffix);
    if (programRunner(path) == ProgramRunner::OtherRobot)
      EXPECT_THROW(writeOutput(path, {toolpath, bed_from_part}, {}), InvalidInput) << "no joints are known";
    else
      writeOutput(path, {toolpath, bed_from_part}, {});
  }
  EXPECT_EQ(readFile(folder.file("a.csv")).rfind(kCsvHeader, 0), 0U);
  EXPECT_NE(readFile(folder.file("a.gcode")).find("G90"), std::string::npos);
  EXPECT_EQ(readFile(folder.file("a.mod")).rfind("MODULE a\n", 0), 0U);
}

TEST(OutputWriter, WritesAFileForEachModule) {
  const test::ScratchFolder folder;
  const Toolpath toolpath = oneLine();
  ProgramSettings settings;
  settings.rapid.max_points = 1;
  writeOutput(folder.file("a.mod"), {toolpath, Eigen::Isometry3d::Identity()}, settings);
  EXPECT_EQ(folder.fileCount(), 3U);
  EXPECT_EQ(readFile(folder.file("a_2.mod")).rfind("MODULE a_2\n", 0), 0U);
}

TEST(OutputWriter, NamesWhatALongerProgramLeft) {
  const test::ScratchFolder folder;
  for (const char* name :
       {"a_1.mod", "a_2.mod", "a_3.mod", "a_10.mod", "a_3.src", "b_4.mod", "a_x.mod", "a_3b.mod"})
    writeFile(folder.file(name), "");
  const std::string path = folder.file("a.mod");
  using Names = std::vector<std::string>;
  EXPECT_EQ(filesOfLongerProgram(path, {"a.mod", "a_1.mod", "a_2.mod"}), (Names{"a_3.mod", "a_10.mod"}));
  EXPECT_EQ(filesOfLongerProgram(path, {"a.mod"}), (Names{"a_1.mod", "a_2.mod", "a_3.mod", "a_10.mod"}));
  EXPECT_EQ(filesOfLongerProgram(folder.file("a_2.mod"), {"a_2.mod"}), Names{});
  EXPECT_EQ(filesOfLongerProgram(folder.file("c.src"), {"c.src", "c.dat"}), Names{});
}

TEST(OutputWriter, RefusesASuffixWithoutWriter) {
  for (const char* path : {"a.stl", "a", ".gcode", "a.gcode.old", "folder.gcode/a"})
    EXPECT_THROW(outputWriterFor(path), InvalidInput) << path;
}

TEST(OutputWriter, LeavesAnExistingFileWhenTheToolpathIsRefused) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("a.gcode")) << "precious";
  const Toolpath empty;
  const Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  EXPECT_THROW(writeOutput(folder.file("a.gcode"), {empty, bed_from_part}, {}), InvalidInput);
  EXPECT_EQ(readFile(folder.file("a.gcode")), "precious");
}

TEST(OutputWriter, RefusesAFolderThatIsNotThere) {
  const Toolpath toolpath = oneLine();
  const Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  EXPECT_THROW(writeOutput("/nowhere/a.csv", {toolpath, bed_from_part}, {}), FileError);
}

TEST(OutputWriter, ThatWasAddedIsChosenByItsSuffix) {
  ProgramWriter points;
  points.write = [](const PlacedToolpath& placed, const ProgramSettings&, const TextSink& sink) {
    for (const Point3& point : placed.toolpath.layers[0].paths[0].points)
      sink(std::to_string(std::lround(point.x())) + "\n");
  };
  const test::ScopedEntry<ProgramWriter> entry(programWriters(), ".points", points);
  const test::ScratchFolder folder;
  const Toolpath toolpath = oneLine();
  writeOutput(folder.file("a.points"), {toolpath, Eigen::Isometry3d::Identity()}, {});
  EXPECT_EQ(readFile(folder.file("a.points")), "0\n5\n");
}

TEST(OutputWriter, WritesGcodeInTheDialectOfTheSettings) {
  const test::ScratchFolder folder;
  ProgramSettings settings;
  settings.dialect = "fullcontrol";
  const Toolpath toolpath = oneLine();
  writeOutput(folder.file("a.gcode"), {toolpath, Eigen::Isometry3d::Identity()}, settings);
  EXPECT_NE(readFile(folder.file("a.gcode")).find(";END OF THE START GCODE"), std::string::npos);
  settings.dialect = "morse";
  EXPECT_THROW(writeOutput(folder.file("a.gcode"), {toolpath, Eigen::Isometry3d::Identity()}, settings),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
