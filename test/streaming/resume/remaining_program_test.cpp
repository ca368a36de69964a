// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/resume/remaining_program.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/streaming/resume/resume_point.hpp"

namespace lamina {
namespace {

StreamableProgram wholeOf(const std::string& text) { return StreamableProgram::fromText("part", text); }

std::string restFrom(const std::string& text, std::uint64_t line, double nozzle_height_mm = 50.0,
                     const ResumeSettings& settings = {}) {
  std::string rest;
  writeRemaining(wholeOf(text), line, nozzle_height_mm, settings,
                 [&](std::string_view piece) { rest += piece; });
  std::string commands;
  ProgramCursor cursor = wholeOf(rest).open();
  while (const auto command = cursor.next()) commands += command->command + "\n";
  return commands;
}

// By hand: a filament of 2 mm has pi mm2, so that 31.4159... mm3 are 10 mm of it.
ResumeSettings byHand() {
  ResumeSettings settings;
  settings.filament_diameter_mm = 2.0;
  settings.purge_mm3 = 31.41592653589793;
  return settings;
}

const char* const kPart =
    "M140 S60\nM104 S210\nG28\nM190 S60\nM109 S210\nG90\nM82\nG92 E0\nG1 X20 Y20 Z0.2 F3000\n"  // 9 lines
    "G1 E2 F300\nM106 S128\n;LAYER:0\nG1 X40 E3 F1200\nG1 Y40 E4\n;LAYER:1\nG1 Z0.4\nG1 X20 E5\nG1 Y20 E6\n";

TEST(ResumePoint, IsBehindTheLastLineThatWasTaken) {
  const ResumePoint amid = resumePointAfter(wholeOf(kPart), 14);
  EXPECT_EQ(amid.line, 15U);
  EXPECT_EQ(amid.layer, 1);
  EXPECT_EQ(amid.layer_line, 14U);
  EXPECT_DOUBLE_EQ(amid.height_mm, 0.4);
  const ResumePoint between = resumePointAfter(wholeOf(kPart), 13);
  EXPECT_EQ(between.layer, 1);
  EXPECT_DOUBLE_EQ(between.height_mm, 0.2);
  EXPECT_FALSE(resumePointAfter(wholeOf(kPart), 0).layer);
  EXPECT_THROW(resumePointAfter(wholeOf(kPart), 16), InvalidInput) << "it has 16 lines";
  EXPECT_NE(adviceFor(amid).find("--from-layer 1  which begins at line 14\n--from-height 0.4 "),
            std::string::npos);
}

TEST(RestProgram, BeginsInTheOrderThatKeepsThePart) {
  EXPECT_EQ(restFrom(kPart, 15, 50.0, byHand()),
            "G21\nG90\nM83\n"
            "M140 S60\nM190 S60\n"    // the bed first
            "G92 Z50\nG28 X Y\n"      // z is told
            "M109 S210\nM106 S128\n"  // nozzle and fan
            "G1 Z5.4 F3000\n"         // 5 mm above z = 0.4
            "G1 X0 Y0 F3000\nG1 E10 F120\nG1 E-1 F120\n"
            "G1 X40 Y40 F3000\nG1 X40 Y40 Z0.4 F600\nG1 E1 F120\n"
            "G92 E4\nG90\nM82\nG1 F1200\n"
            "M220 S50\nG1 X20 E5\nM220 S100\nG1 Y20 E6\n");
}

TEST(RestProgram, IsTheSameOfAProgramWithoutBlanks) {
  const std::string part = std::string("M203 X100\nM203 Y90\n") + kPart;
  const std::string spaced = restFrom(part, 17, 50.0, byHand());
  const auto unspaced = [](std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
  };
  EXPECT_NE(spaced.find("M203 X100\nM203 Y90\n"), std::string::npos) << spaced;
  EXPECT_EQ(unspaced(restFrom(unspaced(part), 17, 50.0, byHand())), unspaced(spaced));
}

TEST(RestProgram, FindsLayersAndHeights) {
  EXPECT_EQ(firstLineOfLayer(wholeOf(kPart), 0), 12U);
  EXPECT_EQ(firstLineOfLayer(wholeOf(kPart), 1), 14U);
  EXPECT_THROW(firstLineOfLayer(wholeOf(kPart), 2), InvalidInput);
  EXPECT_EQ(firstLineAtHeight(wholeOf(kPart), 0.0), 12U);
  EXPECT_EQ(firstLineAtHeight(wholeOf(kPart), 0.4), 15U);
  EXPECT_THROW(firstLineAtHeight(wholeOf(kPart), 0.5), InvalidInput);
}

TEST(RestProgram, RecoversEveryMode) {
  const std::string rest = restFrom(
      "G28\nT1\nM104 S200\nM104 T0 S150\nM204 P500\nM204 T900\nM204 P700\nG55\nG18\nG20\nG91\nG1 X1 Y1 Z1 "
      "F100\n"
      "G92 X0 E3\nM220 S80\nM106 P1 S9\nM107\nG1 X0.1 E0.5\nG1 X0.1 E-0.1\nG1 X1 E1\n",
      19, 100.0);
  for (const char* const line :
       {"M104 T0 S150\n", "T1\n", "M109 S200\n", "M204 T900\nM204 P700\n", "G55\n", "G18\n",
        "M106 P1 S9\nM107\n", "G20\nG91\nM83\nG1 F100\n", "M220 S40\nG1 X1 E1\nM220 S80\n"})
    EXPECT_NE(rest.find(line), std::string::npos) << line << "is not in\n" << rest;
  // x: 0.2 in after G92 X0; E: 3.4 in; 0.1 in of filament are pulled back, of which 1 mm was by the purge.
  EXPECT_NE(rest.find("G92 X5.08 E86.36\n"), std::string::npos) << rest;
  EXPECT_NE(rest.find("Z25.4 F600\nG1 E-1.54 F120\n"), std::string::npos) << rest;
}

TEST(RestProgram, ComesAlongTheToolAxis) {
  ResumeSettings settings = byHand();
  settings.tool_axis = {0.0, -1.0, 1.0};  // tilted by 45 degrees
  const std::string rest = restFrom(kPart, 15, 50.0, settings);
  EXPECT_NE(rest.find("G1 X40 Y35 F3000\nG1 X40 Y40 Z0.4 F600\n"), std::string::npos) << rest;
  settings.tool_axis = {1.0, 0.0, 0.0};
  EXPECT_THROW(restFrom(kPart, 15, 50.0, settings), InvalidConfig);
}

TEST(RestProgram, NeverHomesZ) {
  for (std::uint64_t line = 6; line <= 16; ++line) {
    const std::string rest = restFrom(kPart, line);
    EXPECT_EQ(rest.find("G28 X Y\n"), rest.rfind("G28")) << rest;
  }
}

TEST(RestProgram, RefusesWhatWouldHarmThePart) {
  EXPECT_THROW(restFrom(kPart, 15, 5.3), InvalidInput) << "homing would pass 4.9 mm above the part";
  EXPECT_NO_THROW(restFrom(kPart, 15, 5.4));
  ResumeSettings settings;
  settings.purge_at_mm = {30.0, 30.0};
  EXPECT_THROW(restFrom(kPart, 15, 50.0, settings), InvalidInput) << "on the part";
  EXPECT_THROW(restFrom(kPart, 0), InvalidInput);
  EXPECT_THROW(restFrom(kPart, 17), InvalidInput);
  EXPECT_THROW(restFrom("M200 D1.75\nG1 X1\n", 2), InvalidProgram);
}

TEST(RestProgram, TellsWhatSomebodyHasToSee) {
  const auto notes =
      writeRemaining(wholeOf("G28\nG29\nM42 P1 S1\nM42 P2 S1\nG1 X1\n"), 5, 50.0, {}, [](auto) {});
  std::string all;
  for (const std::string& note : notes.to_check) all += note + "\n";
  for (const char* const part : {"still holds", "z = 50 mm", "as hot as it was", "\"G29\"", "\"M42 P1 S1\""})
    EXPECT_NE(all.find(part), std::string::npos) << part << " is not in\n" << all;
  EXPECT_EQ(all.find("M42 P2"), std::string::npos) << "once for each kind";
}

struct Bead {
  Point3 start;
  Point3 end;
  double filament_mm = 0.0;
};

std::vector<Bead> beadsOf(const std::string& text) {
  std::vector<Bead> beads;
  GcodeHandlers handlers;
  handlers.motion = [&](const GcodeMotion& motion) {
    if (motion.extrusion_mm > 0.0 && motion.start != motion.end)
      beads.push_back({motion.start, motion.end, motion.extrusion_mm});
  };
  GcodeReader reader({}, handlers);
  reader.read(text);
  reader.finish();
  return beads;
}

/// Motions in modes that change at random.
std::string randomProgram(Random& random, int lines) {
  std::string text = "G28\nG90\nM83\n";
  for (int i = 0; i < lines; ++i) {
    switch (random.below(14)) {
      case 0:
        text += random.below(2) == 0 ? "G90\n" : "G91\n";
        break;
      case 1:
        text += random.below(2) == 0 ? "M82\n" : "M83\n";
        break;
      case 2:
        text += "G92 E" + std::to_string(random.uniform(0.0, 9.0)) + "\n";
        break;
      case 3:
        text += "G92 X" + std::to_string(random.uniform(0.0, 9.0)) + "\n";
        break;
      case 4:
        text += random.below(2) == 0 ? "G20\n" : "G21\n";
        break;
      case 5:
        text += "G1 E-" + std::to_string(random.uniform(0.0, 1.0)) + "\n";
        break;
      default:
        text += "G1 X" + std::to_string(random.uniform(0.5, 9.0)) + " Y" +
                std::to_string(random.uniform(0.5, 9.0)) + " E" + std::to_string(random.uniform(0.0, 2.0)) +
                " F900\n";
    }
  }
  return text;
}

RC_GTEST_PROP(RestProgram, HeadAndRestDepositWhatTheWholeDoesOnce, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const std::string whole = randomProgram(random, 40);
  const auto program = wholeOf(whole);
  const std::uint64_t from = 4 + random.below(program.lines() - 3);
  std::string head;
  ProgramCursor cursor = program.open();
  for (std::uint64_t line = 1; line < from; ++line) head += cursor.next()->command + "\n";
  ResumeSettings settings;
  settings.purge_at_mm = {-50'000.0, 0.0};
  std::vector<Bead> parts = beadsOf(head);
  // The machine stands where it was told to stand.
  for (const Bead& bead : beadsOf("G1 Z50\n" + restFrom(whole, from, 50.0, settings))) parts.push_back(bead);
  const std::vector<Bead> meant = beadsOf(whole);
  RC_ASSERT(parts.size() == meant.size());
  constexpr double kRounding = 2e-4;  // mm: four decimals
  for (std::size_t i = 0; i < meant.size(); ++i) {
    RC_ASSERT((parts[i].start - meant[i].start).norm() < kRounding);
    RC_ASSERT((parts[i].end - meant[i].end).norm() < kRounding);
    RC_ASSERT(std::abs(parts[i].filament_mm - meant[i].filament_mm) < kRounding);
  }
}

}  // namespace
}  // namespace lamina
