// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/dry_run.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"

namespace lamina {
namespace {

/// A program run dry, lines apart.
std::string dryOf(const std::string& program, const DryRunSettings& settings = {}) {
  DryRun run(settings);
  std::string dry;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);)
    if (const auto kept = run.line(line)) dry += *kept + "\n";
  return dry;
}

std::string dryRefusal(const std::string& program, const DryRunSettings& settings = {}) {
  try {
    dryOf(program, settings);
  } catch (const InvalidProgram& refused) {
    return refused.what();
  }
  return "nothing was thrown";
}

TEST(DryRun, LeavesOutTheExtruderAndKeepsItsFeed) {
  EXPECT_EQ(dryOf("G1 X10 Y20 E1.5 F1200\n"), "G1 X10 Y20 F1200\n");
  EXPECT_EQ(dryOf("G1X10Y20E-1.5\n"), "G1 X10 Y20\n");
  EXPECT_EQ(dryOf("g1 x10 e.5\n"), "g1 x10\n");
  EXPECT_EQ(dryOf("G1 X1\nG1 E-2 F2400\nG1 X2\n"), "G1 X1\nG1 F2400\nG1 X2\n") << "a feed is modal";
  EXPECT_EQ(dryOf("G1 X1\nG1 E-2\nG1 X2\n"), "G1 X1\nG1 X2\n");
  EXPECT_EQ(dryOf("G0 X1\nG1 E-2\nX2\n"), "G0 X1\nG1\nX2\n") << "which motion it is is modal";
  EXPECT_EQ(dryOf("G1 X1\nX2 E1\nE3\n"), "G1 X1\nX2\n");
  EXPECT_EQ(dryOf("G2 X1 Y2 I3 J4 E0.2\n"), "G2 X1 Y2 I3 J4\n");
  EXPECT_EQ(dryOf("G92 E0\nG92 X0 E0\nG92\n"), "G92 X0\nG92\n") << "G92 alone sets all axes";
  EXPECT_EQ(dryOf("M82\nM83\nG10\nG11\nG10 L2 P1 X3\nG10 P0 R120 S210\nG10 P0 X3 S210\n"),
            "M82\nM83\nG10 L2 P1 X3\nG10 P0 X3\n");
}

TEST(DryRun, LeavesOutWhatSwitchesOnAndKeepsWhatSwitchesOff) {
  EXPECT_EQ(
      dryOf("M104 S210\nM109 S210\nM109 R210\nM140 S60\nM190 S60\nM141 S40\nM191 S40\nM106 S255\nM106\n"),
      "");
  EXPECT_EQ(dryOf("M104 S0 T1\nM109 S0\nM190 S0\nM106 P1 S0\nM107\n"),
            "M104 S0 T1\nM104 S0\nM140 S0\nM106 P1 S0\nM107\n");
  EXPECT_EQ(dryOf("M3 S1000\nG1 X5 S300\nS500\nG1 X6 M4 S200\nM5\nM7\nM8\nM9\n"),
            "M5\nG1 X5\nG1 X6 M5\nM5\nM9\n");
  EXPECT_EQ(dryOf("T1\nM6 T2\nT0 M6\nM116\nM303 E0 S210\nM600\nM302 S0\nM221 S120\nG26 B60 H200\n"), "");
  EXPECT_EQ(dryOf("G28 ; home\nG29\nM117 hot M104 S200\nM400\nG4 P500\nM84\n"),
            "G28 ; home\nG29\nM117 hot M104 S200\nM400\nG4 P500\nM84\n");
  EXPECT_EQ(dryOf(";LAYER:3\nM104 S200 ; heat\n\n%\n"), ";LAYER:3\n; heat\n\n%\n");
  EXPECT_EQ(dryOf("N12 G1 X1 E2*99\n"), "G1 X1\n");
  EXPECT_EQ(dryOf("G1 (fast E9) X1 E2\n"), "G1 X1\n");
}

TEST(DryRun, LeavesOutOrRefusesWhatItDoesNotKnow) {
  DryRun run({});
  EXPECT_EQ(run.line("G28"), "G28");
  EXPECT_EQ(run.line("START_PRINT BED_TEMP=60"), std::nullopt);
  EXPECT_EQ(run.line("M98 P\"heat.g\""), std::nullopt);
  EXPECT_EQ(run.line("SET_HEATER_TEMPERATURE HEATER=extruder TARGET=210"), std::nullopt);
  EXPECT_EQ(run.line("set_velocity_limit ACCEL=500"), "set_velocity_limit ACCEL=500");
  EXPECT_EQ(run.line("PURGE"), std::nullopt) << "letters alone are a macro";
  EXPECT_EQ(run.report().unknown, 3U);
  EXPECT_EQ(run.report().process, 1U);
  EXPECT_EQ(
      toText(run.report()),
      "dry run: 1 commands and words of the process taken out, 3 commands left out that are not known to "
      "switch nothing on, the first in line 2: 'START_PRINT BED_TEMP=60'");
  DryRunSettings strict;
  strict.unknown = UnknownCommand::Refuse;
  EXPECT_NE(dryRefusal("G28\nSTART_PRINT\n", strict).find("line 2"), std::string::npos);
  EXPECT_NE(dryRefusal("G28\nG77 X3\n").find("is not known"), std::string::npos);
  EXPECT_NE(dryRefusal("G28\nG1 X{var.x}\n").find("line 2"), std::string::npos);
  EXPECT_NE(dryRefusal("G28\nif {true}\n").find("statement"), std::string::npos);
  EXPECT_NE(dryRefusal("G28\nG1 S1 X-300\n").find("homing"), std::string::npos);
  EXPECT_NE(dryRefusal("G1 X1 M104 S200\n").find("line by itself"), std::string::npos);
}

TEST(DryRun, RefusesCommandsBehindWhatItCannotRead) {
  for (const char* const line : {"M9 M3 S[1000]", "M0 M4 S#1", "M557 X10:200 Y10:200 M106 S255",
                                 "M566 X600:600M104 S200", "M118 P0 S\"start\" M104 S210",
                                 "M117 \"hi\" M106 S255", "M486 S1 A\"part\" G1 E5 F300", "M400 P{var.x}"})
    EXPECT_NE(dryRefusal(std::string("G28\n") + line + "\n").find("line 2"), std::string::npos) << line;
  const std::string kept =
      "M557 X10:200 Y10:200\nM566 X600:600\nM118 P0 S\"M104 S210\"\nM486 S1 A\"part G1\"\nM486 Arod_T1\n";
  EXPECT_EQ(dryOf(kept), kept);
}

TEST(DryRun, LeavesNothingOfAllAxesWhereItWasOfTheExtruderAlone) {
  EXPECT_EQ(dryOf("G28 G1 X1 E5 F300\n"), "G28 G1 X1 F300\n");
  EXPECT_EQ(dryOf("G29 E1\nG30 E1\n"), "G29 E1\nG30 E1\n") << "it is of the probe";
  EXPECT_EQ(dryOf("G90 G92 E0\nG61 E\nG92 E0\nG92.1 E0\nG92 G90 X1 E0\n"), "G90\nG92.1\nG92 G90 X1\n");
  DryRunSettings settings;
  settings.extrusion = "A";
  EXPECT_EQ(dryOf("G28 A0\nG30 A10\nG28 X0 A0\nG28\n", settings), "G28 X0\nG28\n");
}

TEST(DryRun, KeepsNoTemperaturesOfOffsets) {
  EXPECT_EQ(dryOf("G10 L1 P0 S210 R150\nG10 L1 P0 X3 S210\nG10 L20 P1 X0\nG10 L2 P1 R30\n"),
            "G10 L1 P0 X3\nG10 L20 P1 X0\nG10 L2 P1 R30\n");
}

TEST(DryRun, KeepsOfTargetsOfNoughtWhatSwitchesOff) {
  EXPECT_EQ(dryOf("M106 P1 S0 T45 H1\nM106 S0 T1\nM104 S0 S210\nM104 S0 T1 T2\nM140 S0 H2\n"),
            "M106 P1 S0\nM106 S0\nM140 S0 H2\n");
}

TEST(DryRun, KeepsWhatStandsBehindAChangeOfTool) {
  EXPECT_EQ(dryOf("T1 G90 G54\nT1 G0 Z50\nT1\n"), "G90 G54\nG0 Z50\n");
}

TEST(DryRun, ScalesFeeds) {
  DryRunSettings settings;
  settings.speed = 0.25;
  EXPECT_EQ(dryOf("G1 X1 E1 F1201\nG93\nG1 X2 F0.3\nG4 P200\nG1 F0\n", settings),
            "G1 X1 F300.25\nG93\nG1 X2 F0.075\nG4 P200\nG1 F0\n");
  for (const double speed : {0.0, 0.009, 3.01}) {
    settings.speed = speed;
    EXPECT_THROW(DryRun{settings}, InvalidConfig) << speed;
  }
}

TEST(DryRun, LeavesOutOtherLettersOfTheExtruder) {
  DryRunSettings settings;
  settings.extrusion = "U";
  EXPECT_EQ(dryOf("G1 X1 A30 U2\nG92 U0\n", settings), "G1 X1 A30\n");
  settings.extrusion = "X";
  EXPECT_THROW(DryRun{settings}, InvalidConfig);
}

TEST(DryRun, WritesAFile) {
  const ScratchFolder folder;
  std::istringstream program("G28\nM104 S200\nG1 X1 E1\n");
  const DryRunReport report = writeDryRun(program, folder.path() + "/dry.gcode", {});
  EXPECT_EQ(readFile(folder.path() + "/dry.gcode"), "G28\nG1 X1\n");
  EXPECT_EQ(report.lines, 3U);
  EXPECT_EQ(report.process, 2U);
}

/// The places that a program goes to, by a reader of its own.
std::vector<std::array<double, 3>> placesOf(const std::string& program) {
  std::array<double, 3> at{};
  bool is_absolute = true;
  std::vector<std::array<double, 3>> places;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.find(';'));
    if (line == "G90" || line == "G91") is_absolute = line == "G90";
    const bool sets = line.rfind("G92", 0) == 0;
    if (!sets && line.rfind("G1", 0) != 0 && line.rfind("G0", 0) != 0 && line.find_first_of("XYZ") != 0)
      continue;
    bool has_moved = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t found = line.find("XYZ"[axis]);
      if (found == std::string::npos) continue;
      const std::string number = line.substr(found + 1);
      const double value = std::stod(number.substr(0, number.find_first_not_of(" +-.0123456789")));
      at[axis] = sets || is_absolute ? value : at[axis] + value;
      has_moved = !sets;
    }
    if (has_moved) places.push_back(at);
  }
  return places;
}

/// Whether a command, without comments, runs something of the process; by rules of the test's own.
bool isOfProcess(const std::string& command) {
  static const std::regex kCode("^ *([A-Za-z]) *([0-9]+)");
  static const std::regex kExtruder("[Ee] *[-+]?[.0-9]");
  static const std::regex kPower("[Ss] *[+]?0*[.]?0*[1-9]");
  static const std::regex kOff("[Ss] *[-+]?0+([.]0*)?( |$)");
  std::smatch code;
  if (!std::regex_search(command, code, kCode)) return command.find("HEATER=") != std::string::npos;
  const char letter = static_cast<char>(std::toupper(code.str(1)[0]));
  const int number = std::atoi(code.str(2).c_str());
  if (letter == 'T') return true;
  if (letter != 'M') {
    const bool is_retraction =
        letter == 'G' && (number == 11 || (number == 10 && command.find('L') == std::string::npos &&
                                           command.find_first_of("XYZ") == std::string::npos));
    return is_retraction || std::regex_search(command, kExtruder) ||
           (number < 4 && std::regex_search(command, kPower));
  }
  if (number == 104 || number == 140 || number == 141 || number == 106)
    return !std::regex_search(command, kOff);
  for (const int on : {3, 4, 6, 7, 8, 42, 98, 109, 116, 190, 191, 303, 600, 701})
    if (number == on) return true;
  return false;
}

/// The first line that does; empty if there is none.
std::string processLine(const std::string& program) {
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);)
    if (isOfProcess(line.substr(0, line.find(';')))) return line;
  return "";
}

std::string randomLine() {
  const auto number = [] { return std::to_string(*rc::gen::inRange(-5000, 5000) * 0.01); };
  const auto motion = [&] {
    std::string line = *rc::gen::element<std::string>("G1 ", "G0 ", "");
    for (const char axis : {'X', 'Y', 'Z'})
      if (line.empty() || *rc::gen::arbitrary<bool>()) line += axis + number() + " ";
    if (*rc::gen::arbitrary<bool>()) line += "E" + number() + " ";
    if (*rc::gen::inRange(0, 3) == 0) line += "F" + std::to_string(*rc::gen::inRange(1, 9000));
    if (*rc::gen::inRange(0, 6) == 0) line += " ; M104 S200 E1";
    return line;
  };
  if (*rc::gen::inRange(0, 3) > 0) return motion();
  return *rc::gen::element<std::string>(
      "G90", "G91", "M82", "M83", "G92 E0", "G92 E12.5", "G92 X1 E2", "G10", "G11", "G1 E-1.2 F2400",
      "G1 E1.2", "M104 S210", "M109 S210", "M109 R90", "M104 S0", "M140 S60", "M190 S60", "M190 R40",
      "M141 S50", "M106 S128", "M107", "T0", "T1", "M3 S900", "M4 S20", "M5", "M6 T2", "M7", "M8", "M9",
      "M117 E1 hot", "M400", "G4 P20", "M600", "M701", "M303 S200 C8", "M98 P\"prime.g\"",
      "START_PRINT EXTRUDER=210", "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=220",
      "SET_VELOCITY_LIMIT ACCEL=300", "M116", "M221 S90", "G10 P1 S210 R180", ";LAYER:4", "", "M204 P800",
      "M84", "g1 x4 e2", "G1X3Y4E5", "G0E3");
}

TEST(DryRun, SwitchesNothingOnAndGoesWhereTheProgramGoes) {
  EXPECT_TRUE(rc::check("a dry run has no process and the program's places", [] {
    std::string program;
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) program += randomLine() + "\n";
    const std::string dry = dryOf(program);
    RC_LOG() << program << "-- dry:\n" << dry;
    RC_ASSERT(processLine(dry) == "");
    RC_ASSERT(placesOf(dry) == placesOf(program));
    RC_ASSERT(dryOf(dry) == dry);
  }));
}

TEST(DryRun, ReadsOrRefusesAnyText) {
  EXPECT_TRUE(rc::check("any bytes are refused or leave no process", [] {
    std::string text;
    for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
      text += *rc::gen::element<std::string>("G1", "M104", "E", "S", "T", " ", "X", "*", ";", "\"", "(", ")",
                                             "N3", "G92", "{", "-", ".", "9", "1", "%", "M", "M117 ", "_");
      if (*rc::gen::inRange(0, 4) == 0) text += *rc::gen::inRange<char>(32, 126);
    }
    try {
      RC_LOG() << text;
      RC_ASSERT(processLine(dryOf(text + "\n")) == "");
    } catch (const InvalidProgram&) {
      RC_SUCCEED("refused");
    }
  }));
}

}  // namespace
}  // namespace lamina
