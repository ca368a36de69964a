// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The comments that report where the layers and the nozzle of a transformed program are.
#include <gtest/gtest.h>

#include <cmath>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

using test::transformed;

const std::string kSquare =
    "M83\n;LAYER:0\nG0 X0 Y0 Z0.5\nG1 X9 E1 F900\nG1 Y9 E1\n;LAYER:1\nG0 X0 Y0 Z1\nG1 X9 E1\nG1 Y9 E1\n"
    "; end of the part\n";

Point3 normalOf(const StatedFrame& frame) { return frame.bed_from_layers * Point3::UnitZ(); }
Point3 toolAxisOf(const StatedFrame& frame) { return frame.bed_from_nozzle * Point3::UnitZ(); }

void expectAlong(const Point3& direction, const Point3& expected) {
  EXPECT_LT((direction - expected.normalized()).norm(), 1e-12) << direction.transpose();
}

TEST(FrameComments, LayersAndNozzleTurnWithTheMap) {
  const test::Transformed about_x = transformed(kSquare, test::withHeight(0.5));
  expectAlong(normalOf(about_x.frame), Point3(0, -1, 1));
  expectAlong(toolAxisOf(about_x.frame), Point3(0, 1, -1));
  EXPECT_NEAR(about_x.report.tool_axis_off_normal_deg, 0.0, 1e-9);
  const StatedFrame about_y =
      transformed(kSquare, test::withHeight(0.5), rotation(Point3::UnitY(), 30.0)).frame;
  expectAlong(normalOf(about_y), Point3(0.5, 0, std::sqrt(0.75)));
  expectAlong(toolAxisOf(about_y), Point3(-0.5, 0, -std::sqrt(0.75)));
}

TEST(FrameComments, AreLeftOutWhereLayersStayLevel) {
  for (const AffineMap& map : {rotation(Point3::UnitZ(), 30.0), rotation(Point3::UnitX(), 0.0),
                               scaling(Point3(2, 1, 3)), shear(0, 1, 0.5)}) {
    RewriteSettings settings = test::withHeight(0.5);
    const test::ScratchFolder folder;
    writeFile(folder.file("in.gcode"), kSquare);
    NoProgress nobody;
    rewriteProgram({folder.file("in.gcode"), folder.file("out.gcode")}, {map}, settings, nobody);
    EXPECT_FALSE(test::contains(readFile(folder.file("out.gcode")), "FRAME"));
  }
}

TEST(FrameComments, PlanesOfAShearAreThoseItsPointsLieIn) {
  // z += 0.5 y: points of a level layer lie in z - 0.5 y = const.
  const StatedFrame sheared = transformed(kSquare, test::withHeight(0.5), shear(2, 1, 0.5)).frame;
  expectAlong(normalOf(sheared), Point3(0, -0.5, 1));
}

TEST(FrameComments, ReportTheHeadOfTheMachineWhereItIsHeldOtherwise) {
  RewriteSettings settings = test::withHeight(0.5);
  settings.tool_axis = Point3(0, 0, -2);
  settings.tool_axis_rule = ToolAxisRule::AsMachine;
  const test::Transformed down = transformed(kSquare, settings);
  expectAlong(toolAxisOf(down.frame), Point3(0, 0, -1));
  EXPECT_NEAR(down.report.tool_axis_off_normal_deg, 45.0, 1e-9);
  EXPECT_TRUE(isToolAxisOffNormal(down.report));
}

TEST(FrameComments, TheFrameReportedIsTurnedFurther) {
  RewriteSettings settings = test::withHeight(0.5);
  const std::string stated = frameComments(transformed(kSquare, settings).frame);
  const test::Transformed twice = transformed(stated + kSquare, settings);
  expectAlong(normalOf(twice.frame), Point3(0, -1, 0));
  expectAlong(toolAxisOf(twice.frame), Point3(0, 1, 0));
  const AffineMap back = rotation(Point3::UnitX(), -45.0);
  EXPECT_EQ(frameComments(transformed(stated + kSquare, settings, back).frame), "");
}

TEST(FrameComments, StandBeforeTheBeginCode) {
  RewriteSettings settings = test::withHeight(0.5);
  settings.begin_code = "M117 begin\n";
  const test::ScratchFolder folder;
  writeFile(folder.file("in.gcode"), ";head\n" + kSquare);
  NoProgress nobody;
  rewriteProgram({folder.file("in.gcode"), folder.file("out.gcode")}, {test::aboutX45()}, settings, nobody);
  const std::string text = readFile(folder.file("out.gcode"));
  EXPECT_EQ(text.find(";head\n;LAYER_FRAME: "), 0U) << text;
  EXPECT_LT(text.find(";NOZZLE_FRAME: "), text.find("\nM117 begin\nM83\n"));
}

TEST(FrameComments, TheListingWritesNone) {
  RewriteSettings settings = test::withHeight(0.5);
  settings.mode = RewriteMode::Listing;
  EXPECT_EQ(frameComments(transformed(kSquare, settings).frame), "");
}

TEST(FrameComments, ProgramsThatSpeakAxesAskewAreRefused) {
  StatedFrame belt;
  belt.bed_from_program = beltAxes(45.0).matrix().inverse();
  EXPECT_THROW(transformed(frameComments(belt) + kSquare, test::withHeight(0.5)), InvalidProgram);
  EXPECT_THROW(transformed(";LAYER_FRAME: 1 1 1 1\n" + kSquare, test::withHeight(0.5)), InvalidProgram);
}

TEST(FrameComments, LayersAreReadBackAsTheyWereSlicedWhateverTheAxes) {
  const AffineMap belt = beltAxes(45.0);
  for (const SpaceMap* axes : {static_cast<const SpaceMap*>(nullptr), static_cast<const SpaceMap*>(&belt)}) {
    const test::Transformed inclined = transformed(kSquare, test::withHeight(0.5), test::aboutX45(), axes);
    const Toolpath read =
        toolpathFromGcode(frameComments(inclined.frame) + inclined.text, ProgramSettings{}, "square");
    ASSERT_EQ(read.layers.size(), 2U);
    EXPECT_NEAR(inclinationDeg(read), 45.0, 1e-9);
    EXPECT_NEAR(read.layers[1].z_mm - read.layers[0].z_mm, 0.5, 2e-3) << "three decimals were written";
    const Point3 normal = layerNormal(read);
    for (const ToolpathLayer& layer : read.layers)
      for (const Path& path : layer.paths) {
        if (path.role == PathRole::Travel) continue;
        for (const Point3& point : path.points) EXPECT_NEAR(normal.dot(point), layer.z_mm, 2e-3);
        expectAlong(path.orientation.at(0) * Point3::UnitZ(), Point3(0, 1, -1));
      }
    // The corner of the first layer, at (9, 0, 0.5) as sliced and lifted to 0.5 mm over the bed.
    const Path& first = read.layers[0].paths.back();
    EXPECT_LT((first.points[1] - Point3(9, -0.5 * M_SQRT1_2, 0.5)).norm(), 2e-3);
  }
}

}  // namespace
}  // namespace lamina
