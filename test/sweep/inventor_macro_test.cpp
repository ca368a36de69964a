// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/inventor_macro.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// What the macro would sweep.
struct ReadSweep {
  std::vector<double> frame;  ///< middle, side, up, width, height
  std::vector<Point3> path;   ///< middles of the bead
  bool is_finished = false;
};

std::vector<double> numbersOf(std::string list) {
  for (char& c : list)
    if (c == ',') c = ' ';
  std::istringstream words(list);
  std::vector<double> numbers;
  for (double number = 0.0; words >> number;) numbers.push_back(number);
  return numbers;
}

/// Follows the calls of the procedures of beads in the order in which the macro calls these.
class MacroReader {
 public:
  explicit MacroReader(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
      EXPECT_EQ(line.back(), '\r');
      line.pop_back();
      follow(line);
    }
  }

  std::vector<ReadSweep> sweeps;
  std::size_t procedures = 0;
  std::size_t called = 0;
  std::size_t longest = 0;  ///< procedure, in statements

 private:
  void follow(const std::string& line) {
    const auto after = [&](const char* word) { return numbersOf(line.substr(std::string(word).size())); };
    if (line.rfind("Private Sub Beads", 0) == 0) ++procedures, statements_ = 0;
    if (line.rfind("  Beads", 0) == 0) ++called;
    longest = std::max(longest, ++statements_);
    if (line.rfind("  BeginBead ", 0) == 0) {
      const std::vector<double> frame = after("  BeginBead ");
      ASSERT_EQ(frame.size(), 11U);
      sweeps.push_back({frame, {Point3(frame[0], frame[1], frame[2])}, false});
    } else if (line.rfind("  LineTo ", 0) == 0) {
      const std::vector<double> place = after("  LineTo ");
      ASSERT_EQ(place.size(), 3U);
      ASSERT_FALSE(sweeps.empty() || sweeps.back().is_finished);
      sweeps.back().path.emplace_back(place[0], place[1], place[2]);
    } else if (line == "  EndBead") {
      sweeps.back().is_finished = true;
    }
  }

  std::size_t statements_ = 0;
};

Sweep levelSweep(std::vector<Point3> points) {
  Sweep sweep;
  sweep.points = std::move(points);
  sweep.up.assign(sweep.points.size(), Point3::UnitZ());
  sweep.bead = {0.48, 0.3};
  return sweep;
}

TEST(InventorMacro, ReadBackHasProfileAndPathOfEachSweep) {
  const MacroReader read(inventorMacro(
      {levelSweep({{0, 0, 0.3}, {5, 0, 0.3}, {6, 1, 0.3}}), levelSweep({{1, 1, 0.6}, {1, 4, 0.6}})}));
  ASSERT_EQ(read.sweeps.size(), 2U);
  EXPECT_EQ(read.sweeps[0].frame, (std::vector<double>{0, 0, 0.15, 0, -1, 0, 0, 0, 1, 0.48, 0.3}));
  ASSERT_EQ(read.sweeps[0].path.size(), 3U);
  EXPECT_EQ(read.sweeps[0].path[2], Point3(6, 1, 0.15));
  EXPECT_EQ(read.sweeps[1].frame[3], 1.0);
  EXPECT_EQ(read.sweeps[1].path[1], Point3(1, 4, 0.45));
  EXPECT_TRUE(read.sweeps[0].is_finished && read.sweeps[1].is_finished);
  EXPECT_EQ(read.called, read.procedures);
}

TEST(InventorMacro, CutsSweepsWhereInventorCannotGoRound) {
  // Back by 135 degrees, and a line of 0.2 mm: of lines the last three go on.
  const MacroReader read(inventorMacro({levelSweep(
      {{0, 0, 0.3}, {5, 0, 0.3}, {4, 1, 0.3}, {4, 1.2, 0.3}, {4, 5, 0.3}, {6, 8, 0.3}, {9, 8, 0.3}})}));
  std::vector<std::size_t> lines;
  for (const ReadSweep& sweep : read.sweeps) lines.push_back(sweep.path.size() - 1);
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 1, 1, 3}));
}

TEST(InventorMacro, CutsALoopBeforeItsLastLine) {
  Sweep square = levelSweep({{0, 0, 0.3}, {9, 0, 0.3}, {9, 9, 0.3}, {0, 9, 0.3}, {0, 0, 0.3}});
  square.is_loop = true;
  const MacroReader read(inventorMacro({square}));
  ASSERT_EQ(read.sweeps.size(), 2U);  // as one solid its first line would run into its last one
  EXPECT_EQ(read.sweeps[0].path.back(), Point3(0, 9, 0.15));
  EXPECT_EQ(read.sweeps[1].path, (std::vector<Point3>{{0, 9, 0.15}, {0, 0, 0.15}}));
}

std::size_t countOf(const std::string& words, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

/// Inventor's CreatePath follows lines that share a sketch point; lines between equal places are apart.
TEST(InventorMacro, LetsLinesShareTheirSketchPoints) {
  const std::string macro = inventorMacro({levelSweep({{0, 0, 0.3}, {5, 0, 0.3}, {6, 1, 0.3}})});
  for (const char* points :
       {"Private lastPlace As SketchPoint3D\r\n", "Private lastCorner As SketchPoint\r\n",
        "  way.SketchLines3D.AddByTwoPoints lastPlace, place, False\r\n  Set lastPlace = place\r\n",
        "  sketch.SketchLines.AddByTwoPoints lastCorner, corner\r\n  Set lastCorner = corner\r\n",
        "    Set corner = firstCorner\r\n"})
    EXPECT_EQ(countOf(points, macro), 1U) << points;
  EXPECT_EQ(countOf("AddByTwoPoints", macro), 2U);
  EXPECT_EQ(countOf("AddByThreePoints lastCorner, ", macro), 1U);
  EXPECT_EQ(countOf(".CreateSweepDefinition(kPathSweepType, outline, ", macro), 1U);
}

TEST(InventorMacro, ParcelsOutProceduresThatVbaTakes) {
  std::vector<Point3> points;
  for (int i = 0; i <= 3000; ++i) points.emplace_back(i, std::sin(i), 0.3);
  const MacroReader read(inventorMacro({levelSweep(points)}));
  ASSERT_EQ(read.sweeps.size(), 1U);
  EXPECT_EQ(read.sweeps[0].path.size(), points.size());
  EXPECT_EQ(read.called, read.procedures);
  EXPECT_GT(read.procedures, 7U);
  EXPECT_LE(read.longest, 410U);
  EXPECT_THROW(inventorMacro({}), InvalidInput);
}

}  // namespace
}  // namespace lamina
