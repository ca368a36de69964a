// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Arcs in programs: as written, and as read back.
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/full_control_writer.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

namespace lamina {
namespace {

constexpr double kRadius = 10.0;

/// A wall round (50, 60) by 360 chords.
Toolpath circle() {
  Path path;
  path.role = PathRole::OuterWall;
  path.is_closed = true;
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * M_PI / 180.0;
    path.points.emplace_back(50.0 + kRadius * std::cos(angle), 60.0 + kRadius * std::sin(angle), 0.2);
  }
  Toolpath toolpath;
  toolpath.part_name = "circle";
  toolpath.layers.push_back({0.2, 0.2, {path}});
  return toolpath;
}

ProgramSettings withArcs(double tolerance_mm) {
  ProgramSettings settings;
  settings.start_code = settings.end_code = "";
  settings.arcs_tolerance_mm = tolerance_mm;
  return settings;
}

std::string writtenWithArcs(const Toolpath& toolpath, double tolerance_mm = 0.01,
                            const ProgramFrame& frame = ProgramFrame(Eigen::Isometry3d::Identity())) {
  std::string text;
  writeGcode(toolpath, frame, withArcs(tolerance_mm), [&](std::string_view piece) { text += piece; });
  return text;
}

std::size_t countOf(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(ArcWriting, MakesACircleOfTwoArcs) {
  const std::string text = writtenWithArcs(circle());
  EXPECT_EQ(countOf(text, "\nG3 "), 2U) << text;
  EXPECT_EQ(countOf(text, "\nG1 "), 0U) << text;
  // 180 chords of 2 r sin(0.5 deg), of 0.071416 mm² in filament of 1.75 mm.
  EXPECT_NE(text.find("G3 X40 Y60 I-10 J0 E0.9327"), std::string::npos) << text;
}

TEST(ArcWriting, ReadsBackWithinTheToleranceAndWithTheVolumeOfTheChords) {
  const Toolpath toolpath = circle();
  const Toolpath read = toolpathFromGcode(writtenWithArcs(toolpath), ProgramSettings(), "circle");
  double volume_mm3 = 0.0;
  for (const Path& path : read.layers.at(0).paths) {
    if (path.role == PathRole::Travel) continue;
    volume_mm3 += depositedVolume(path);
    for (const Point3& point : path.points)
      EXPECT_NEAR((point - Point3(50.0, 60.0, 0.2)).norm(), kRadius, 0.01);
  }
  // Half a unit of the last decimal of E is 1.2e-5 mm³.
  EXPECT_NEAR(volume_mm3, depositedVolume(toolpath.layers[0].paths[0]), 2.5e-5);
}

TEST(ArcWriting, LeavesProgramsWithoutTolerance) {
  const std::string text = writtenWithArcs(circle(), 0.0);
  EXPECT_EQ(countOf(text, "\nG3 "), 0U);
  EXPECT_EQ(countOf(text, "\nG1 "), 360U);
}

TEST(ArcWriting, EndsArcsWhereBeadsFeedsOrEventsChange) {
  Toolpath toolpath = circle();
  Path& path = toolpath.layers[0].paths[0];
  path.events = {{90, Dwell{0.5}}};
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 3U);  // 90, 180 and 90 deg
  std::vector<Bead> beads(360, Bead{0.4, 0.2});
  for (std::size_t i = 46; i <= 90; ++i) beads[i].width_mm = 0.5;
  path.bead = AlongPath<Bead>(beads);
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 4U);  // and at 45 deg
  std::vector<double> feeds(360, 30.0);
  for (std::size_t i = 300; i < 360; ++i) feeds[i] = 30.2;
  path.feed_mm_s = AlongPath<double>(feeds);
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 4U);  // within 1 %
  for (std::size_t i = 300; i < 360; ++i) feeds[i] = 31.0;
  path.feed_mm_s = AlongPath<double>(feeds);
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 5U);
}

TEST(ArcWriting, TakesNoPartOfAHelix) {
  Toolpath toolpath = circle();
  Path& path = toolpath.layers[0].paths[0];
  path.is_closed = false;
  for (std::size_t i = 0; i < path.points.size(); ++i) path.points[i].z() += 0.001 * static_cast<double>(i);
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 0U);
}

TEST(ArcWriting, LeavesTravelsStraight) {
  Toolpath toolpath = circle();
  Path travel = toolpath.layers[0].paths[0];
  travel.role = PathRole::Travel;
  travel.is_closed = false;
  travel.bead = Bead{};
  toolpath.layers[0].paths = {travel};
  EXPECT_EQ(countOf(writtenWithArcs(toolpath), "\nG3 "), 0U);
}

TEST(ArcWriting, IsRefusedWhereThereAreNoArcs) {
  ProgramFrame belt(Eigen::Isometry3d::Identity());
  belt.program_from_bed.linear()(2, 1) = 1.0;
  EXPECT_THROW(writtenWithArcs(circle(), 0.01, belt), InvalidConfig);
  Toolpath inclined = circle();
  inclined.part_from_layers = Eigen::AngleAxisd(0.5, Point3::UnitX());
  EXPECT_THROW(writtenWithArcs(inclined), InvalidConfig);
  Toolpath drops = circle();
  drops.layers[0].paths[0].deposit = Deposit::Drops;
  EXPECT_THROW(writtenWithArcs(drops), InvalidConfig);
  EXPECT_THROW(writeFullControl(circle(), ProgramFrame(Eigen::Isometry3d::Identity()), withArcs(0.01),
                                [](std::string_view) { FAIL(); }),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
