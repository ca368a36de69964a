// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/full_control_writer.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

namespace lamina {
namespace {

/// Two layers of two beads each, with travels between.
Toolpath grating() {
  Toolpath toolpath;
  toolpath.part_name = "grating";
  Point3 last = Point3::Zero();
  for (int layer = 0; layer < 2; ++layer) {
    ToolpathLayer made;
    made.z_mm = 0.3 * (layer + 1);
    made.height_mm = 0.3;
    for (int line = 0; line < 2; ++line) {
      Path path;
      path.feed_mm_s = 20.0;
      path.bead = Bead{0.48, 0.3};
      path.points = {Point3(0, 3.0 * line, made.z_mm), Point3(10, 3.0 * line, made.z_mm),
                     Point3(10, 3.0 * line + 1.0, made.z_mm)};
      if (layer + line > 0) {
        Path travel;
        travel.role = PathRole::Travel;
        travel.feed_mm_s = 100.0;
        travel.points = {last, path.firstPoint()};
        made.paths.push_back(travel);
      }
      last = path.lastPoint();
      made.paths.push_back(path);
    }
    toolpath.layers.push_back(made);
  }
  return toolpath;
}

std::string fullControlWriterWritten(const Toolpath& toolpath) {
  std::string text;
  writeFullControl(toolpath, {}, {}, [&text](std::string_view piece) { text += piece; });
  return text;
}

TEST(FullControlWriterTest, HasTheMarksOfTheDialectAndNoOtherComments) {
  const std::string text = fullControlWriterWritten(grating());
  EXPECT_EQ(text.rfind(";FLAVOR:", 0), 0U);
  const std::size_t begin = text.find(";END OF THE START GCODE\n");
  const std::size_t end = text.find(";START OF THE END GCODE\n");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  EXPECT_EQ(text.find(';', begin + 1), end);
  EXPECT_EQ(text.substr(begin, 80).find("G0 F1200 X0 Y0\nG0 Z0.3\nG1 X10 E0.51838\nG1 Y1 E0.05184\n"),
            std::string(";END OF THE START GCODE\n").size());
}

TEST(FullControlWriterTest, IsReadBackAsWhatWasWritten) {
  const Toolpath toolpath = grating();
  const Toolpath read = toolpathFromGcode(fullControlWriterWritten(toolpath), {}, "grating");
  ASSERT_EQ(read.layers.size(), 2U);
  const ToolpathTotals before = totals(toolpath);
  const ToolpathTotals after = totals(read);
  EXPECT_EQ(after.deposition_runs, before.deposition_runs);
  EXPECT_NEAR(after.deposition_mm, before.deposition_mm, 1e-6);
  EXPECT_NEAR(after.deposited_mm3, before.deposited_mm3, 1e-4 * before.deposited_mm3);
}

TEST(FullControlWriterTest, RefusesWhatTheDialectCannotTell) {
  EXPECT_THROW(fullControlWriterWritten({}), InvalidInput);
  Toolpath tilted = grating();
  tilted.layers[1].paths.back().orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Point3::UnitX())) * nozzleDown();
  EXPECT_THROW(fullControlWriterWritten(tilted), InvalidInput);
  Toolpath drops = grating();
  drops.layers[0].paths[0].deposit = Deposit::Drops;
  EXPECT_THROW(fullControlWriterWritten(drops), InvalidInput);
}

}  // namespace
}  // namespace lamina
