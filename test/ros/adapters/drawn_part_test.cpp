// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_panel/drawing/drawn_part.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/scratch_folder.hpp"

namespace {

using lamina::DrawnPart;

DrawnPart drawnFile(const std::string& path, bool is_given_up = false) {
  const std::atomic<bool> is_cancelled{is_given_up};
  return lamina::drawProgram(path, "bed", is_cancelled);
}

DrawnPart drawn(const std::string& program, bool is_given_up = false) {
  const lamina::test::ScratchFolder folder;
  std::ofstream(folder.file("part.gcode")) << program;
  return drawnFile(folder.file("part.gcode"), is_given_up);
}

TEST(DrawnPart, HoldsTheLayersOfAForeignProgram) {
  const DrawnPart part =
      drawn(";LAYER:0\nG1 X10 Y20 Z0.5 F900\nG1 X15 E1\n;LAYER:1\nG1 X15 Y22 Z1\nG1 X12 E2\n");
  EXPECT_EQ(part.failure, "");
  EXPECT_EQ(part.layers, 2U);
  EXPECT_TRUE(part.box.low.isApprox(lamina::Point3(10, 20, 0.5))) << part.box.low.transpose();
  EXPECT_TRUE(part.box.high.isApprox(lamina::Point3(15, 22, 1))) << part.box.high.transpose();
  std::size_t points = 0;
  for (const auto& chunk : part.chunks) points += chunk.marker.points.size();
  EXPECT_GE(points, 4U);
}

TEST(DrawnPart, ReportsWhyItIsNotDrawn) {
  EXPECT_NE(drawnFile("/nowhere/part.gcode").failure.find("/nowhere/part.gcode"), std::string::npos);
  EXPECT_NE(drawn("M104 S200\n").failure.find("nothing to draw"), std::string::npos);
  EXPECT_NE(drawn("G1 Xx\n").failure, "");
}

TEST(DrawnPart, IsGivenUpWhenAnotherIsWanted) {
  const DrawnPart part = drawn(";LAYER:0\nG1 X10 E1\n", true);
  EXPECT_EQ(part.layers, 0U);
  EXPECT_NE(part.failure, "");
}

}  // namespace
