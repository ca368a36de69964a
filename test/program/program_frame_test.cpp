// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/program_frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kWritten = 1.1e-3;  // mm: diagonal of half a unit of the third decimals

Eigen::Quaterniond aboutX(double angle_deg) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * M_PI / 180.0, Point3::UnitX()));
}

/// Axis values of a belt printer of that angle.
Eigen::Affine3d beltFromBed(double angle_deg) {
  const double angle = angle_deg * M_PI / 180.0;
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() << 1, 0, 0, 0, 0, 1 / std::sin(angle), 0, -1, 1 / std::tan(angle);
  return map;
}

ProgramSettings programFramePlainSettings() {
  ProgramSettings settings;
  settings.start_code = "";
  settings.end_code = "";
  return settings;
}

std::string programFrameWritten(const Toolpath& toolpath, const ProgramFrame& frame) {
  std::string text;
  writeGcode(toolpath, frame, programFramePlainSettings(), [&](std::string_view piece) { text += piece; });
  return text;
}

TEST(ProgramFrame, EachPointOfAnInclinedLayerHasItsOwnZ) {
  // A line up an incline of 45 deg, 10 mm long: as much filament and feed as on the level.
  Toolpath level;
  level.part_name = "line";
  level.layers.push_back({0.2, 0.2, {test::straightPath({0, 0, 0.2}, {0, 10, 0.2})}});
  const std::string text = programFrameWritten(turned(level, aboutX(45)), ProgramFrame());
  EXPECT_NE(text.find(";LAYER_FRAME: 0.92387953251128674 0.38268343236508978 0 0\n;NOZZLE_FRAME:"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("G0 X0 Y-0.141 F1800\nG0 Z0.141\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Y6.93 Z7.212 E0.29691 F1800\n"), std::string::npos) << text;
}

TEST(ProgramFrame, StartAndEndCodeLiftTheNozzleAndDoNotMoveTheBelt) {
  Toolpath level;
  level.layers.push_back({0.0, 0.2, {test::straightPath({0, 0, 0.2}, {0, 10, 0.2})}});
  const auto withCode = [&](const ProgramFrame& frame) {
    std::string text;
    writeGcode(level, frame, ProgramSettings{}, [&](std::string_view piece) { text += piece; });
    return text;
  };
  const std::string over_bed = withCode(ProgramFrame());
  EXPECT_NE(over_bed.find("G28\nG0 Z5 F600\n"), std::string::npos) << over_bed;
  EXPECT_NE(over_bed.find("G91\nG0 Z5 F600\nG90\n"), std::string::npos) << over_bed;
  ProgramFrame belt;
  belt.program_from_bed = beltFromBed(45);
  const std::string over_belt = withCode(belt);
  EXPECT_NE(over_belt.find("G28\nG0 Y5 F600\n"), std::string::npos) << over_belt;
  EXPECT_NE(over_belt.find("G91\nG0 Y5 F600\nG90\n"), std::string::npos) << over_belt;
}

TEST(ProgramFrame, AxesOfABeltMoveSoFastThatTheNozzleKeepsItsFeed) {
  // 10 mm up the belt's incline of 30 deg are 10 mm of y alone; 10 mm straight up are 20 mm of y and
  // 10 cot 30 of belt.
  Toolpath up;
  up.layers.push_back({0.0, 0.2, {test::straightPath({0, 0, 0}, {0, 0, 10})}});
  ProgramFrame frame;
  frame.program_from_bed = beltFromBed(30);
  const std::string text = programFrameWritten(up, frame);
  const double factor = std::sqrt(4.0 + 3.0);
  EXPECT_NE(text.find("Y20 Z17.321 E0.29691 F" + std::to_string(1800 * factor).substr(0, 8)),
            std::string::npos)
      << text;
}

TEST(ProgramFrame, AProgramIsReadBackAsItWasPlanned) {
  EXPECT_TRUE(rc::check("inclined layers on a belt", [](std::uint64_t seed) {
    Random random(seed);
    const double angle = random.uniform(15.0, 75.0);
    const Toolpath toolpath = turned(test::twoLayers(), aboutX(angle));
    ProgramFrame frame;
    frame.bed_from_part.translation() = Point3(random.uniform(0, 100), random.uniform(-100, 0), 3.0);
    frame.program_from_bed = beltFromBed(angle);
    const Toolpath back =
        toolpathFromGcode(programFrameWritten(toolpath, frame), programFramePlainSettings(), "square");
    RC_ASSERT(std::abs(inclinationDeg(back) - angle) < 1e-6);
    RC_ASSERT(back.layers.size() == 2U);
    for (std::size_t l = 0; l < 2; ++l) {
      const Path& read = back.layers[l].paths.back();
      const Path& planned = toolpath.layers[l].paths.back();
      RC_ASSERT((read.lastPoint() - frame.bed_from_part * planned.lastPoint()).norm() < 6 * kWritten);
      RC_ASSERT((read.orientation.at(0) * Point3::UnitZ()).isApprox(-layerNormal(toolpath), 1e-9));
    }
    RC_ASSERT(std::abs(totals(back).deposition_mm - 50.0) < 0.02);
    RC_ASSERT(std::abs(totals(back).deposited_mm3 / totals(toolpath).deposited_mm3 - 1.0) < 1e-3);
    RC_ASSERT(std::abs(back.layers[0].paths[0].feed_mm_s.at(1) - 30.0) < 0.02);
  }));
}

TEST(ProgramFrame, AnUprightNozzleOverInclinedLayersIsReadBack) {
  const Toolpath toolpath = withNozzle(turned(test::twoLayers(), aboutX(20)), nozzleDown());
  const std::string text = programFrameWritten(toolpath, ProgramFrame());
  EXPECT_EQ(text.find("NOZZLE_FRAME"), std::string::npos);
  const Toolpath back = toolpathFromGcode(text, programFramePlainSettings(), "square");
  EXPECT_NEAR(inclinationDeg(back), 20.0, 1e-9);
  EXPECT_TRUE(
      (back.layers[0].paths[0].orientation.at(0) * Point3::UnitZ()).isApprox(-Point3::UnitZ(), 1e-12));
}

TEST(ProgramFrame, ACsvReportsInclinedLayers) {
  const Toolpath toolpath = turned(test::twoLayers(), aboutX(45));
  std::string text;
  writeCsv(toolpath, [&](std::string_view piece) { text += piece; });
  const Toolpath back = readCsv(text, "square");
  EXPECT_NEAR(inclinationDeg(back), 45.0, 1e-9);
  EXPECT_NEAR(back.layers[0].z_mm, 0.2, 1e-12);
  EXPECT_THROW(readCsv("#nothing\n" + text, "square"), InvalidProgram);
}

TEST(ProgramFrame, DropsOnInclinedLayersAreWrittenAndNotReadBackAsLevel) {
  Toolpath drops;
  Path drop = test::straightPath({0, 0, 0.2}, {1, 0, 0.2});
  drop.deposit = Deposit::Drops;
  drops.layers.push_back({0.2, 0.2, {drop}});
  EXPECT_NO_THROW(
      toolpathFromGcode(programFrameWritten(drops, ProgramFrame()), programFramePlainSettings(), "drops"));
  const std::string inclined = programFrameWritten(turned(drops, aboutX(30)), ProgramFrame());
  EXPECT_THROW(toolpathFromGcode(inclined, programFramePlainSettings(), "drops"), InvalidProgram);
}

TEST(ProgramFrame, RefusesFramesThatAreNone) {
  StatedFrame read;
  EXPECT_FALSE(readFrameComment("TYPE:infill", read));
  EXPECT_THROW(readFrameComment("LAYER_FRAME: 1 1 0 0", read), InvalidProgram);
  EXPECT_THROW(readFrameComment("NOZZLE_FRAME: 1 0", read), InvalidProgram);
  EXPECT_THROW(readFrameComment("BED_FROM_AXES: 1 0 0 0 0 1 0 0 0 1 0 0", read), InvalidProgram);
}

}  // namespace
}  // namespace lamina
