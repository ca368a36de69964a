// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::contains;
using test::motionsOf;
using test::transformed;

const std::string kLayer =
    "M83\n;LAYER:0\nG0 X0 Y0 Z0 F6000\nG1 X10 E1 F600\nG1 Y10 E1\nG1 E-2 F1800\nG1 X0 E1\n";

TEST(Maps, AScaledPartIsFilledByItsVolume) {
  const std::string text = transformed(kLayer, test::asSliced(), scaling({2.0, 1.0, 3.0})).text;
  EXPECT_EQ(text,
            "M83\n;LAYER:0\nG0 X0.000 Y0.000 Z0.000 F6000.00\n"
            "G1 X20.000 Y0.000 Z0.000 E6.00000 F1200.00\n"  // twice as long in the same time
            "G1 X20.000 Y10.000 Z0.000 E6.00000 F600.00\n"
            "G1 E-2.00000 F1800.00\n"
            "G1 X0.000 Y10.000 Z0.000 E6.00000 F3600.00\n");
}

TEST(Maps, BeadsKeepTheirSectionIfExtrusionFollowsLength) {
  RewriteSettings settings = test::asSliced();
  settings.extrusion_rule = ExtrusionRule::ByLength;
  const auto motions = motionsOf(transformed(kLayer, settings, scaling({2.0, 1.0, 3.0})).text);
  ASSERT_EQ(motions.size(), 4U);
  EXPECT_DOUBLE_EQ(motions[0].extrusion_mm, 2.0);
  EXPECT_DOUBLE_EQ(motions[1].extrusion_mm, 1.0);
  EXPECT_DOUBLE_EQ(motions[2].extrusion_mm, -2.0);
}

TEST(Maps, AbsoluteExtrusionIsCountedAnew) {
  const std::string text =
      transformed("M82\nG92 E5\n;LAYER:0\nG0 X0 Y0 Z0\nG1 X1 E6\nG1 E4\nG92 E0\nG1 E2\nG1 X2 E3\n",
                  test::asSliced(), scaling({2.0, 2.0, 1.0}))
          .text;
  EXPECT_TRUE(contains(text, "Z0.000 E9.00000\nG1 E7.00000\nG92 E0\nG1 E2.00000\n")) << text;
  EXPECT_TRUE(contains(text, "G1 X4.000 Y0.000 Z0.000 E6.00000\n")) << text;
}

TEST(Maps, ABeltPrinterGetsTheCoordinatesOfItsAxes) {
  // Upright after the rotation; then y up the leaning gantry, z along the belt. What is deposited stays.
  const AffineMap belt = beltAxes(45.0);
  const std::string program = "M83\n;LAYER:0\nG0 X0 Y0 Z0 F600\nG1 Y10 E1\nG1 X10 E1\n";
  const std::string text = transformed(program, test::asSliced(), test::aboutX45(), &belt).text;
  // (0, 10, 0) comes to (0, 7.071, 7.071) over the bed: 10 up the gantry, where the belt has not moved.
  EXPECT_TRUE(contains(text, "G1 X0.000 Y10.000 Z0.000 E1\n")) << text;
  EXPECT_TRUE(contains(text, "G1 X10.000 Y10.000 Z0.000 E1\n")) << text;
}

TEST(Maps, ABeltGoesOnFromLayerToLayer) {
  const AffineMap belt = beltAxes(45.0);
  std::string program = "M83\n";
  for (const char* layer : {"0", "1", "2"})
    program += std::string(";LAYER:") + layer + "\nG0 X0 Y0 Z" + layer + "\nG1 Y10 E1\n";
  const std::string text = transformed(program, test::asSliced(), test::aboutX45(), &belt).text;
  // Layers 1 mm apart along their normal are sqrt(2) apart along the belt, which stands still within each.
  for (const char* place : {"Y0.000 Z0.000\n", "Y10.000 Z0.000 E1", "Y1.000 Z1.414\n", "Y11.000 Z1.414 E1",
                            "Y2.000 Z2.828\n", "Y12.000 Z2.828 E1"})
    EXPECT_TRUE(contains(text, place)) << place << " in\n" << text;
}

TEST(Maps, AFeedThatIsReportedAgainIsScaledAgain) {
  const std::string text =
      transformed("M83\n;LAYER:0\nG0 X0 Y0 Z0 F600\nG1 X1 E1 F600\nG1 X2 E1 F600\nG1 X3 E1\n",
                  test::asSliced(), scaling({2.0, 2.0, 2.0}))
          .text;
  EXPECT_TRUE(contains(text, "X2.000 Y0.000 Z0.000 E8.00000 F1200.00\n")) << text;
  EXPECT_TRUE(contains(text, "X4.000 Y0.000 Z0.000 E8.00000 F1200.00\nG1 X6.000 Y0.000 Z0.000 E8.00000\n"))
      << text;
}

TEST(Maps, AbsoluteExtrusionGoesOnWhereRelativeExtrusionLeftIt) {
  // 5 absolute, 3 relative, then to 10: 2 more. Volumes are eight times as large.
  const std::string text =
      transformed("M82\nG92 E0\n;LAYER:0\nG0 X0 Y0 Z0\nG1 X1 E5\nM83\nG1 X2 E3\nM82\nG1 X3 E10\n",
                  test::asSliced(), scaling({2.0, 2.0, 2.0}))
          .text;
  EXPECT_TRUE(contains(text, "Z0.000 E40.00000\nM83\n")) << text;
  EXPECT_TRUE(contains(text, "Z0.000 E24.00000\nM82\n")) << text;
  EXPECT_TRUE(contains(text, "X6.000 Y0.000 Z0.000 E80.00000\n")) << text;
}

TEST(Maps, WhatComesFurtherThanCanBeWrittenNamesItsLine) {
  Eigen::Affine3d far = Eigen::Affine3d::Identity();
  far.translation().x() = 1e13;
  try {
    transformed(kLayer, test::asSliced(), AffineMap(far));
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_TRUE(contains(error.what(), "line 3: ")) << error.what();
  }
}

TEST(Maps, ABeltPrintersFinalPositionIsNotGuessed) {
  RewriteSettings settings = test::asSliced();
  settings.final_position_mm = Point3(1.0, 2.0, 3.0);
  const AffineMap belt = beltAxes(45.0);
  EXPECT_THROW(transformed(kLayer, settings, test::aboutX45(), &belt), InvalidConfig);
}

/// Layers become hills: z rises with x and y.
class Hill final : public SpaceMap {
 public:
  Point3 map(const Point3& p) const override { return p + Point3(0.0, 0.0, height(p)); }
  Point3 inverse(const Point3& p) const override { return p - Point3(0.0, 0.0, height(p)); }

 private:
  static double height(const Point3& p) { return 0.002 * (p.x() * p.x() + p.y() * p.y()); }
};

TEST(Maps, ALineThatAMapBendsIsFollowedWithinTheTolerance) {
  RewriteSettings settings = test::asSliced();
  settings.decimals = 6;
  const auto motions =
      motionsOf(transformed("M82\n;LAYER:0\nG0 X-50 Y0 Z0 F600\nG1 X50 E10 F600\n", settings, Hill()).text);
  ASSERT_GT(motions.size(), 10U);
  double pushed = 0.0;
  for (std::size_t i = 1; i < motions.size(); ++i) {
    const Point3 middle = 0.5 * (motions[i].start + motions[i].end);
    const double bed = 0.002 * middle.x() * middle.x();
    EXPECT_LE(std::abs(middle.z() - bed), settings.chord_tolerance_mm);
    EXPECT_NEAR(motions[i].end.z(), 0.002 * motions[i].end.x() * motions[i].end.x(), 1e-6);
    pushed += motions[i].extrusion_mm;
  }
  EXPECT_NEAR(pushed, 10.0, 1e-4);  // the map keeps volumes
  EXPECT_NEAR(motions.back().end.x(), 50.0, 1e-6);
}

TEST(Arcs, BecomeChordsWithinTheTolerance) {
  const std::string program = "M83\n;LAYER:0\nG0 X10 Y0 Z3\nG3 X-10 Y0 I-10 J0 E4 F900 ;half\nG1 X0 E1\n";
  const auto done = transformed(program, test::asSliced());
  EXPECT_EQ(done.report.arcs, 1U);
  const AffineMap back = test::aboutX45();
  const auto motions = motionsOf(done.text);
  double pushed = 0.0;
  for (std::size_t i = 1; i + 1 < motions.size(); ++i) {
    const Point3 middle = back.inverse(0.5 * (motions[i].start + motions[i].end));
    EXPECT_NEAR(middle.head<2>().norm(), 10.0, 0.011);
    EXPECT_NEAR(middle.z(), 3.0, 1e-3);
    EXPECT_GE(middle.y(), -1e-3);
    pushed += motions[i].extrusion_mm;
  }
  EXPECT_NEAR(pushed, 4.0, 1e-9);
  EXPECT_TRUE(contains(done.text, " F900\n"));
  EXPECT_TRUE(contains(done.text, " ;half\n"));
  EXPECT_FALSE(contains(done.text, "G3"));
}

TEST(Arcs, AreReadByRadiusToo) {
  const auto byCentre =
      transformed("M83\n;LAYER:0\nG0 X10 Y0 Z0\nG3 X0 Y10 I-10 J0 E4\n", test::asSliced()).text;
  const auto byRadius = transformed("M83\n;LAYER:0\nG0 X10 Y0 Z0\nG3 X0 Y10 R10 E4\n", test::asSliced()).text;
  EXPECT_EQ(byCentre, byRadius);
}

}  // namespace
}  // namespace lamina
