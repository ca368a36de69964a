// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::motionsOf;
using test::transformed;

const double kEdge = 350.0;
const double kMiddle = 302.125;  // of the edge it stands on
const double kCubeHalf = std::sqrt(0.5);

/// A cube of 350 mm that stands on an edge along x, sliced in layers of 1.5 mm.
std::string cubeOnAnEdge() {
  std::ostringstream program;
  program.precision(12);
  program << ";Layer height: 1.5\nM83\n";
  for (int k = 1; k <= 329; ++k) {
    const double z = 1.5 * k;
    const double half_width = z <= kEdge * kCubeHalf ? z : kEdge / kCubeHalf - z;
    const double low = kMiddle - half_width;
    const double high = kMiddle + half_width;
    program << ";LAYER:" << k - 1 << "\nG0 X475 Y" << low << " Z" << z << "\nG1 X825 E1\nG1 Y" << high
            << " E1\nG1 X475 E1\nG1 Y" << low << " E1\n";
  }
  return program.str();
}

RewriteSettings onTheLargeGantry() {
  RewriteSettings settings;
  settings.limits_mm = Box3{Point3::Zero(), Point3(1300.0, 2500.0, 1000.0)};
  settings.decimals = 6;
  return settings;
}

TEST(CubeOnAnEdge, ComesOutUprightAtItsSize) {
  RewriteSettings settings = onTheLargeGantry();
  settings.limits_mm.reset();
  const Box3 part = transformed(cubeOnAnEdge(), settings).report.part;
  EXPECT_NEAR(part.size().x(), kEdge, 1e-6);
  EXPECT_NEAR(part.low.y(), kMiddle * kCubeHalf - kEdge, 1e-4);
  EXPECT_NEAR(part.high.y(), kMiddle * kCubeHalf, 1e-4);
  EXPECT_NEAR(part.low.z(), 1.5, 1e-6);
  EXPECT_NEAR(part.high.z(), 351.5, 1e-4);
}

TEST(CubeOnAnEdge, StandsOnItsWholeFace) {
  const Box3 footprint = transformed(cubeOnAnEdge(), test::withHeight(1.5)).report.footprint;
  EXPECT_NEAR(footprint.size().x(), kEdge, 1e-6);
  EXPECT_NEAR(footprint.size().y(), kEdge, 3.0);  // the slicer's layers end within a layer of the edge
}

TEST(CubeOnAnEdge, BeginsOnTheBed) {
  const RewriteReport report = transformed(cubeOnAnEdge(), test::withHeight(1.5)).report;
  EXPECT_NEAR(report.first_layer_gap_mm, 0.0, 1e-6);
  EXPECT_FALSE(beginsInAir(report));
  EXPECT_EQ(noticeOnFirstLayer(report), "");
}

/// A ball of 20 mm on its slicer's bed, in layers of 0.2 mm, each by the corners of a square in its circle.
std::string ball() {
  constexpr double kRadius = 10.0;
  std::ostringstream program;
  program.precision(12);
  program << ";Layer height: 0.2\nM83\n";
  for (int k = 1; k < 100; ++k) {
    const double z = 0.2 * k;
    const double r = std::sqrt(kRadius * kRadius - (z - kRadius) * (z - kRadius));
    program << ";LAYER:" << k - 1 << "\nG0 X" << r << " Y0 Z" << z << "\nG1 X0 Y" << r << " E1\nG1 X" << -r
            << " Y0 E1\nG1 X0 Y" << -r << " E1\nG1 X" << r << " Y0 E1\n";
  }
  return program.str();
}

/// Its first layer has a radius of 1.98997 mm, 9.8 mm below the middle: turned, it ends
/// (1.98997 + 9.8) / sqrt 2 = 8.337 mm below, and the ball 10 mm below.
TEST(Ball, BeginsInMidAirOnceItIsTurned) {
  const RewriteReport report = transformed(ball(), test::withHeight(0.2)).report;
  EXPECT_NEAR(report.first_layer_gap_mm, 10.0 - 8.337, 0.01);
  EXPECT_TRUE(beginsInAir(report));
  EXPECT_TRUE(test::contains(noticeOnFirstLayer(report), "begins 1.66 mm above the bed"))
      << noticeOnFirstLayer(report);
  const RewriteReport level =
      transformed(ball(), test::withHeight(0.2), rotation(Point3::UnitX(), 0.0)).report;
  EXPECT_NEAR(level.first_layer_gap_mm, 0.0, 1e-9);
}

TEST(CubeOnAnEdge, StandsOnThatEdgeWhereItIsNotTurned) {
  const Box3 footprint =
      transformed(cubeOnAnEdge(), test::withHeight(1.5), rotation(Point3::UnitX(), 0.0)).report.footprint;
  EXPECT_LT(footprint.size().y(), 7.0);
}

TEST(CubeOnAnEdge, MustBeMovedOntoTheBed) {
  RewriteSettings settings = onTheLargeGantry();
  try {
    transformed(cubeOnAnEdge(), settings);
    FAIL();
  } catch (const Unreachable& error) {
    EXPECT_TRUE(test::contains(error.what(), "y = -136.365 mm")) << error.what();
    EXPECT_TRUE(test::contains(error.what(), "moved by 136.365 mm")) << error.what();
  }
  settings.offset_mm.y() = 136.37;
  EXPECT_NO_THROW(transformed(cubeOnAnEdge(), settings));
  settings.offset_mm.y() = 0.0;
  settings.table_position_mm = Point2(650.0, 1250.0);
  EXPECT_NEAR(transformed(cubeOnAnEdge(), settings).report.part.low.y(), 1075.0, 1e-6);
}

TEST(CubeOnAnEdge, KeepsItsLayersOnPlanesAtTheAngle) {
  RewriteSettings settings = test::asSliced();
  settings.decimals = 6;
  const auto sliced = motionsOf(cubeOnAnEdge());
  const auto inclined = motionsOf(transformed(cubeOnAnEdge(), settings).text);
  ASSERT_EQ(sliced.size(), inclined.size());
  for (std::size_t i = 0; i < sliced.size(); ++i)
    EXPECT_NEAR(-kCubeHalf * inclined[i].end.y() + kCubeHalf * inclined[i].end.z(), sliced[i].end.z(), 2e-6);
}

TEST(CubeOnAnEdge, KeepsThePitchOfItsLayersAlongEachAxis) {
  // Layers of 1.5 mm at 45 deg are 2.1213 mm apart straight up, and as much along y.
  RewriteSettings settings = test::asSliced();
  settings.decimals = 6;
  const std::string layers = "M83\n;LAYER:0\nG0 X0 Y0 Z1.5\nG1 X5 E1\n;LAYER:1\nG0 X0 Y0 Z3\nG1 X5 E1\n";
  const auto motions = motionsOf(transformed(layers, settings).text);
  const Point3 step = motions[2].end - motions[0].end;
  const Point3 normal(0.0, -kCubeHalf, kCubeHalf);
  EXPECT_NEAR(normal.dot(step) / normal.z(), 2.1213, 1e-4);
  EXPECT_NEAR(normal.dot(step) / -normal.y(), 2.1213, 1e-4);
}

TEST(CubeOnAnEdge, HopsAlongTheNormalOfItsLayers) {
  const auto motions = motionsOf(
      transformed("M83\n;LAYER:0\nG0 X0 Y20 Z0\nG1 X5 E1\nG0 Z3\nG0 Z0\nG1 X9 E1\n", test::asSliced()).text);
  EXPECT_LT((motions[2].end - motions[1].end - Point3(0.0, -2.1213, 2.1213)).norm(), 2e-3);
}

TEST(CubeOnAnEdge, KeepsEverySegmentsLengthWithinTheRounding) {
  RewriteSettings settings = test::asSliced();
  settings.decimals = 2;
  const auto sliced = motionsOf(cubeOnAnEdge());
  const auto inclined = motionsOf(transformed(cubeOnAnEdge(), settings).text);
  ASSERT_EQ(sliced.size(), inclined.size());
  for (std::size_t i = 1; i < sliced.size(); ++i)
    EXPECT_NEAR((inclined[i].end - inclined[i].start).norm(), (sliced[i].end - sliced[i].start).norm(),
                0.0174);
}

TEST(CubeOnAnEdge, IsCompletedByTheIdentity) {
  RewriteSettings settings = test::asSliced();
  settings.decimals = 6;
  const auto done = transformed(cubeOnAnEdge(), settings, rotation(Point3::UnitX(), 0.0));
  const auto sliced = motionsOf(cubeOnAnEdge());
  const auto completed = motionsOf(done.text);
  ASSERT_EQ(sliced.size(), completed.size());
  for (std::size_t i = 0; i < sliced.size(); ++i) EXPECT_LT((sliced[i].end - completed[i].end).norm(), 2e-6);
  std::istringstream lines(done.text);
  for (std::string line; std::getline(lines, line);) {
    if (line[0] != 'G') continue;
    for (const char axis : {'X', 'Y', 'Z'}) EXPECT_NE(line.find(axis), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace lamina
