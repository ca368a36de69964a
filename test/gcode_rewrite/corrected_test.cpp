// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::contains;
using test::motionsOf;
using test::transformed;
using test::withHeight;

const double kHalf = std::sqrt(0.5);

/// A layer that begins in a known place, with relative E.
std::string layer(const std::string& lines) { return "M83\n;LAYER:0\nG0 X0 Y0 Z0\n" + lines; }

TEST(Corrected, ThePublishedExampleLiesOnTheBed) {
  // 0.70710678 (302.047 + 1.5) = 214.640142 is the lowest deposition end, which comes to 1.5.
  EXPECT_EQ(transformed(test::publishedExample(), withHeight(1.5)).text,
            "M83\n;LAYER:0\nM107\n"
            "G1 F1200\n"
            "G0 F18000 X474.333 Y210.398 Z3.621\n"
            ";MESH:Cubo.stl\n;TYPE:WALL-OUTER\n"
            "G1 F1200 X474.333 Y212.519 Z1.500\n"
            "G1 F3600 E13.05577\n"
            "G1 F884.2 X475.099 Y212.575 Z1.556 E0.45598\n"
            "G1 F884.3 X650.239 Y212.574 Z1.555 E103.69276\n"
            "G1 X825.379 Y212.573 Z1.554 E103.69276\n");
}

TEST(Corrected, DecimalsCanBeChosen) {
  RewriteSettings settings = withHeight(1.5);
  settings.decimals = 2;
  const std::string text = transformed(test::publishedExample(), settings).text;
  EXPECT_TRUE(contains(text, "G0 F18000 X474.33 Y210.40 Z3.62\n")) << text;
  EXPECT_TRUE(contains(text, "G1 X825.38 Y212.57 Z1.55 E103.69276\n")) << text;
}

TEST(Corrected, EveryHomingIsAnnulledUnlessKept) {
  const std::string program = "G28 X0 Y0\nG28 ;Home\nG28\n" + layer("G1 X1 E1\n");
  EXPECT_EQ(transformed(program, withHeight(0.2)).text.substr(0, 60),
            ";Anulada: G28 X0 Y0\n;Anulada: G28 ;Home\n;Anulada: G28\nM83\n;L");
  RewriteSettings settings = withHeight(0.2);
  settings.homing = Homing::Kept;
  EXPECT_EQ(transformed(program, settings).text.substr(0, 30), "G28 X0 Y0\nG28 ;Home\nG28\nM83\n;L");
}

TEST(Corrected, OtherLinesKeepEveryByte) {
  const std::string others =
      "G92 E0\nM190 S90\nM107 \t;fan\nM117 G1 X5\nT0\nG4 P5\nG10\nG11\nM73 P1*2\nEXCLUDE_OBJECT_END NAME=a\n";
  EXPECT_TRUE(contains(transformed(layer("G1 X1 E1\n\n \n" + others), withHeight(0.2)).text, others));
}

TEST(Corrected, MotionsBeforeThePartStay) {
  EXPECT_EQ(transformed("G1 X200 Y5 E9 F900\r\n" + layer("G1 X1 E1\n"), withHeight(0.2)).text.substr(0, 20),
            "G1 X200 Y5 E9 F900\r\n");
}

TEST(Corrected, WordsKeepTheirPlaceAndText) {
  const auto rewritten = [](const std::string& line) {
    const std::string before = "G1 X0.000 Y-7.071 Z35.355 E1\n";
    const std::string text =
        transformed(layer("G1 X0 Y20 Z30 E1\n" + line + "\nG1 X0 Y20 Z30 E1\n"), test::asSliced()).text;
    const std::size_t from = text.find(before) + before.size();
    return text.substr(from, text.rfind(before) - from);
  };
  EXPECT_EQ(rewritten("G1 X10 E5.00"), "G1 X10.000 Y-7.071 Z35.355 E5.00\n");
  EXPECT_EQ(rewritten("G1 Y20 X10"), "G1 X10.000 Y-7.071 Z35.355\n");
  EXPECT_EQ(rewritten("G1 X10 Y20 ;Zeta"), "G1 X10.000 Y-7.071 Z35.355 ;Zeta\n");
  EXPECT_EQ(rewritten("G1 X10 (Z1) Y20 S3"), "G1 X10.000 Y-7.071 Z35.355 (Z1) S3\n");
  EXPECT_EQ(rewritten("G01 F1200.0  E.5 X 10."), "G01 F1200.0  E.5 X10.000 Y-7.071 Z35.355\n");
  EXPECT_EQ(rewritten("G1X10Y20E1F5"), "G1 X10.000 Y-7.071 Z35.355 E1F5\n");
  EXPECT_EQ(rewritten("g1 x10 e5"), "g1 X10.000 Y-7.071 Z35.355 e5\n");
  EXPECT_EQ(rewritten("  N5 G0 X10\r"), "  N5 G0 X10.000 Y-7.071 Z35.355\r\n");
  EXPECT_EQ(rewritten("G1 X10 Y20 Z30"), "G1 X10.000 Y-7.071 Z35.355\n");
}

TEST(Corrected, APointBesideTheOriginTurnsAboutX) {
  const std::string text = transformed(layer("G1 X1 E1\nG1 X-5 Y10 Z0.3 E1\n"), test::asSliced()).text;
  EXPECT_TRUE(contains(text, "G1 X-5.000 Y6.859 Z7.283 E1\n")) << text;
}

TEST(Corrected, MotionsWaitUntilEveryCoordinateIsKnown) {
  const std::string text =
      transformed("M83\nG1 X200 Y200 Z9\n;LAYER:0\nG1 Z4.5\nG1 Z5 F300 ;up\nG0 X1 Y2\nG1 X2 E1\n",
                  withHeight(0.2))
          .text;
  EXPECT_TRUE(contains(text, ";LAYER:0\n;Deferred: G1 Z4.5\nG1 F300 ;up\nG0 X1.000 Y-2.121 Z0.200\n"))
      << text;
}

TEST(Corrected, ARisingSpiralKeepsItsRise) {
  std::string program = layer("");
  for (int i = 0; i < 200; ++i)
    program += "G1 X" + std::to_string(10.0 * std::cos(0.1 * i)) + " Y" +
               std::to_string(10.0 * std::sin(0.1 * i)) + " Z" + std::to_string(0.3 + 0.01 * i) + " E0.1\n";
  RewriteSettings settings = test::asSliced();
  settings.offset_mm.z() = 50.0;
  settings.decimals = 6;
  const auto motions = motionsOf(transformed(program, settings).text);
  ASSERT_EQ(motions.size(), 201U);
  for (std::size_t i = 0; i < 200; ++i) {
    const Point3& end = motions[i + 1].end;
    EXPECT_NEAR(-kHalf * end.y() + kHalf * (end.z() - 50.0), 0.3 + 0.01 * static_cast<double>(i), 2e-6);
  }
}

TEST(Corrected, TheLayerHeightIsReadFromTheSlicersComments) {
  for (const std::string head : {";Layer height: 0.4\n", ";HEIGHT:0.4\n", ";   layerHeight,0.4\n"})
    EXPECT_EQ(transformed(head + layer("G1 X1 E1\n"), {}).report.part.low.z(), 0.4) << head;
  EXPECT_EQ(transformed(layer("G1 X1 E1\n; end of the part\n; layer_height = 0.4\n"), {}).report.part.low.z(),
            0.4);
  EXPECT_THROW(transformed(layer("G1 X1 E1\n"), {}), InvalidProgram);
}

TEST(Corrected, ThePartComesWhereItIsWanted) {
  const std::string program = layer("G1 X10 E1\nG1 Y10 E1\n");
  RewriteSettings settings = withHeight(0.2);
  settings.table_position_mm = Point2(100.0, 200.0);
  const Box3 centred = transformed(program, settings).report.part;
  EXPECT_NEAR(centred.centre().x(), 100.0, 1e-9);
  EXPECT_NEAR(centred.centre().y(), 200.0, 1e-9);
  settings.table_position_mm.reset();
  settings.offset_mm = Point3(5.0, 6.0, 7.0);
  const Box3 moved = transformed(program, settings).report.part;
  EXPECT_NEAR(moved.low.x(), 5.0, 1e-9);
  EXPECT_NEAR(moved.low.y(), 6.0, 1e-9);
  EXPECT_NEAR(moved.low.z(), 7.2, 1e-9);
}

TEST(Corrected, LengthsFilamentAndFeedsStay) {
  EXPECT_TRUE(rc::check([] {
    const auto coordinate = [] { return *rc::gen::inRange(-500000, 500000) * 1e-3; };
    std::string program = "M83\n;LAYER:0\nG0 X1 Y2 Z3\n";
    const int count = *rc::gen::inRange(1, 30);
    for (int i = 0; i < count; ++i) {
      program += "G1";
      for (const char axis : {'X', 'Y', 'Z'})
        if (*rc::gen::inRange(0, 3) > 0) program += std::string(" ") + axis + std::to_string(coordinate());
      program += " E" + std::to_string(*rc::gen::inRange(1, 9000) * 1e-3) + " F" +
                 std::to_string(*rc::gen::inRange(1, 9000)) + "\n";
    }
    program += "G1 X5 E1\nG1 X9 E1\n";
    const AffineMap turn = rotation({coordinate() + 1000.0, coordinate(), coordinate()}, coordinate());
    RewriteSettings settings = withHeight(0.2);
    settings.decimals = 6;
    const auto before = motionsOf(program);
    const auto after = motionsOf(transformed(program, settings, turn).text);
    RC_ASSERT(before.size() == after.size());
    for (std::size_t i = 1; i < before.size(); ++i) {
      RC_ASSERT(std::abs((before[i].end - before[i].start).norm() - (after[i].end - after[i].start).norm()) <
                3e-6);
      RC_ASSERT(before[i].extrusion_mm == after[i].extrusion_mm);
      RC_ASSERT(before[i].feed_mm_s == after[i].feed_mm_s);
    }
  }));
}

TEST(Corrected, TheInverseBringsTheProgramBack) {
  const std::string program =
      "M83\n;LAYER:0\nG0 F9000 X1.250 Y-2.000 Z0.200\nG1 X17.125 Y3.000 Z0.200 E1.5\n"
      "G1 X17.125 Y300.000 Z0.300 E12 ;c\nG0 X0.000 Y0.000 Z99.000\nG1 X1.000 Y0.000 Z99.000 E1\n";
  RewriteSettings there = test::asSliced();
  there.decimals = 6;
  there.offset_mm.z() = 100.0;
  RewriteSettings back = test::asSliced();
  const AffineMap turn = rotation({1.0, 2.0, 3.0}, 33.0);
  Eigen::Affine3d undo = turn.matrix().inverse() * Eigen::Translation3d(0.0, 0.0, -100.0);
  EXPECT_EQ(transformed(transformed(program, there, turn).text, back, AffineMap(undo)).text, program);
}

}  // namespace
}  // namespace lamina
