// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_dialect.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_flavour.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// A bead before which the nozzle waits for 1.5 s, and what else happens.
Toolpath beadAfter(const ToolpathEvent& other) {
  Toolpath toolpath{"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {5, 0, 0.2})}}}};
  PathEvent wait;
  wait.event.emplace<Dwell>(Dwell{1.5});
  PathEvent before;
  before.event = other;
  toolpath.layers[0].paths[0].events = {wait, before};
  return toolpath;
}

std::string programOf(const Toolpath& toolpath, const std::string& flavour) {
  ProgramSettings settings;
  settings.flavour = flavour;
  if (!gcodeDialect(flavour).has_heaters) {
    settings.nozzle_temperature_c = settings.bed_temperature_c = 0.0;
    settings.end_code = "M5";
  }
  std::string text;
  writeFlavoured(toolpath, {}, settings, [&](std::string_view piece) { text += piece; });
  return text;
}

MachineCode code() { return {"M3 S100", false}; }

TEST(GcodeDialect, OfKlipperAndRepRapFirmwareIsThatOfMarlinWithinAPart) {
  const std::string marlin = programOf(beadAfter(FanShare{0.5}), "marlin");
  EXPECT_NE(marlin.find("G4 P1500\nM106 S128\nG1 "), std::string::npos) << marlin;
  EXPECT_EQ(programOf(beadAfter(FanShare{0.5}), "klipper"), marlin);
  EXPECT_EQ(programOf(beadAfter(FanShare{0.5}), "reprapfirmware"), marlin);
}

TEST(GcodeDialect, OfGrblHasSecondsAndNoExtruder) {
  const std::string grbl = programOf(beadAfter(code()), "grbl");
  EXPECT_NE(grbl.find("G4 P1.5\nM3 S100\nG1 X"), std::string::npos) << grbl;
  for (const char* word : {" E", "M83", "M104", "G92"}) EXPECT_EQ(grbl.find(word), std::string::npos) << word;
}

TEST(GcodeDialect, OfGrblRefusesWhatItLacks) {
  for (const ToolpathEvent& lacking : {ToolpathEvent(FanShare{1.0}), ToolpathEvent(OperatorPause{})})
    EXPECT_THROW(programOf(beadAfter(lacking), "grbl"), InvalidInput);
  Toolpath second_tool = beadAfter(code());
  second_tool.layers[0].paths[0].tool = 1;
  EXPECT_THROW(programOf(second_tool, "grbl"), InvalidInput);
  ProgramSettings heated;
  heated.flavour = "grbl";
  EXPECT_THROW(writeFlavoured(beadAfter(code()), {}, heated, [](std::string_view) {}), InvalidConfig);
}

TEST(GcodeDialect, PutsNumbersIntoItsLines) {
  const std::string& progress = gcodeDialect("marlin").progress;
  EXPECT_EQ(dialectLine(progress, {{"percent", 12}, {"minutes", 34}}), "M73 P12 R34\n");
  EXPECT_EQ(dialectLine(gcodeDialect("klipper").progress, {{"percent", 12}, {"minutes", 34}}), "M73 P12\n");
}

}  // namespace
}  // namespace lamina
