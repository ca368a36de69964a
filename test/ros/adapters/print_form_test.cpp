// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_panel/print/print_form.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lamina/base/error.hpp"

namespace {

using lamina::durationText;
using lamina::InvalidInput;
using lamina::PrintForm;
using lamina::programOf;
using lamina::requestOf;

PrintForm formOf(const std::string& part) {
  PrintForm form;
  form.part = part;
  return form;
}

std::map<std::string, std::string> byKey(const lamina::SliceRequest& request) {
  std::map<std::string, std::string> settings;
  for (const auto& [key, text] : request.settings) settings[key] = text;
  return settings;
}

TEST(PrintForm, AsksForAProgramBesideTheMesh) {
  PrintForm form = formOf("/parts/Bracket v1.2.STL");
  EXPECT_EQ(requestOf(form).program, "/parts/Bracket v1.2.gcode");
  EXPECT_TRUE(requestOf(form).settings.empty());
  form.program = "/out/b.gcode";
  EXPECT_EQ(requestOf(form).program, "/out/b.gcode");
}

TEST(PrintForm, AsksForWhatProfilesAndSettingsSet) {
  PrintForm form = formOf("a.stl");
  form.machine = "gantry_45";
  form.settings = "# thick\nslicing.layer_height_mm = 0.3\n\n  walls.count=3  # strong\n";
  std::map<std::string, std::string> asked = byKey(requestOf(form));
  EXPECT_EQ(asked.size(), 3U);
  EXPECT_EQ(asked["machine.name"], "gantry_45");
  EXPECT_EQ(asked["slicing.layer_height_mm"], "0.3");
  EXPECT_EQ(asked["walls.count"], "3");
  form.machine = "prusa_mk4";
  form.material = "petg";
  form.process = "fine";
  form.settings = "program.nozzle_temperature_c = 231";
  asked = byKey(requestOf(form));
  EXPECT_EQ(asked["slicing.layer_height_mm"], "0.12") << "of the process";
  EXPECT_EQ(asked["program.nozzle_temperature_c"], "231") << "the settings have the last word";
  EXPECT_NE(asked["machine.urdf"].find("prusa_mk4.urdf"), std::string::npos) << asked["machine.urdf"];
}

TEST(PrintForm, RefusesWhatTheMachineCannotDo) {
  PrintForm form = formOf("a.stl");
  form.machine = "creality_ender_3";
  form.material = "pa_cf";
  EXPECT_THROW(requestOf(form), lamina::InvalidConfig);
}

TEST(PrintForm, RefusesWhatCannotBeSliced) {
  EXPECT_THROW(requestOf(PrintForm()), InvalidInput);
  EXPECT_THROW(requestOf(formOf("blade")), InvalidInput) << "a parametric part has no place of its own";
  EXPECT_THROW(requestOf(formOf("a.gcode")), InvalidInput);
  PrintForm form = formOf("a.stl");
  form.settings = "walls.count 3";
  try {
    requestOf(form);
    FAIL() << "a line without = is taken";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("walls.count 3"), std::string::npos) << error.what();
  }
  form.settings = "";
  form.program = "a.csv";
  EXPECT_THROW(requestOf(form), InvalidInput);
}

TEST(PrintForm, PrintsAProgramAsItIs) {
  EXPECT_TRUE(lamina::isProgram("/p/Part.GCODE"));
  EXPECT_FALSE(lamina::isProgram("/p/part.stl"));
  EXPECT_EQ(programOf(formOf("/p/part.gcode")), "/p/part.gcode");
  EXPECT_EQ(programOf(formOf("blade")), "");
}

TEST(PrintForm, IsTheSameAfterItWasSaved) {
  PrintForm form = formOf("a.stl");
  form.machine = "gantry_45";
  form.material = "pla";
  form.settings = "walls.count = 3\ninfill.density = 0.3";
  const PrintForm loaded = lamina::printFormFrom(textsOf(form));
  EXPECT_EQ(loaded.part, "a.stl");
  EXPECT_EQ(loaded.machine, "gantry_45");
  EXPECT_EQ(loaded.material, "pla");
  EXPECT_EQ(loaded.settings, form.settings);
}

TEST(PrintForm, SaysDurationsAsPeopleDo) {
  EXPECT_EQ(durationText(0.4), "0 s");
  EXPECT_EQ(durationText(59.6), "1 min 0 s");
  EXPECT_EQ(durationText(754.0), "12 min 34 s");
  EXPECT_EQ(durationText(4354.0), "1 h 12 min");
}

}  // namespace
