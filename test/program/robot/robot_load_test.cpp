// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the flange carries, as the controller is told.
#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

RobotProgramSettings withLoad() {
  RobotProgramSettings settings;
  settings.tool_mass_kg = 12.5;
  settings.tool_centre_of_gravity_mm = {-10, 0, 80.5};
  return settings;
}

std::string loadedText(RobotLanguage language, const RobotProgramSettings& settings) {
  return test::robotFiles(language, test::twoLayers(), settings)[0].text;
}

TEST(RobotLoad, OfTheToolGoesWithItInKrl) {
  RobotProgramSettings settings;
  settings.tool_number = 4;
  EXPECT_NE(loadedText(RobotLanguage::Krl, settings).find("$TOOL=TOOL_DATA[4]\n$LOAD=LOAD_DATA[4]\n"),
            std::string::npos);
}

TEST(RobotLoad, IsWrittenWhereItIsKnown) {
  EXPECT_NE(loadedText(RobotLanguage::Krl, withLoad())
                .find("\n$LOAD={M 12.5,CM {X -10.000,Y 0.000,Z 80.500,A 0.0,B 0.0,C 0.0},J {X 0.0,Y 0.0,Z "
                      "0.0}}\n"),
            std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::UrScript, withLoad())
                .find("\n  set_payload(12.5, [-0.010000, 0.000000, 0.080500])\n"),
            std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::Fanuc, withLoad()).find("!# load 12.5 -10 0 80.5"), std::string::npos);
  EXPECT_NE(loadedText(RobotLanguage::Inform, withLoad()).find("'# load 12.5 -10 0 80.5"), std::string::npos);
  EXPECT_EQ(loadedText(RobotLanguage::UrScript, {}).find("set_payload"), std::string::npos);
}

TEST(RobotLoad, OfTheControllerIsChosenInFanucListings) {
  EXPECT_EQ(loadedText(RobotLanguage::Fanuc, {}).find("PAYLOAD"), std::string::npos);
  RobotProgramSettings settings;
  settings.fanuc.payload = 3;
  const auto files = test::robotFiles(RobotLanguage::Fanuc, test::twoLayers(), settings);
  const std::size_t at = files[0].text.find(":  PAYLOAD[3] ;\n");
  ASSERT_NE(at, std::string::npos) << files[0].text;
  EXPECT_GT(at, files[0].text.find("UTOOL_NUM="));
  EXPECT_LT(at, files[0].text.find(" P[1] "));
  EXPECT_EQ(totals(readRobotProgram(files, "part")).deposition_runs, 2U);
}

TEST(RobotLoad, IsReadBackAndSaidOfTheCell) {
  for (const RobotLanguage language : kRobotLanguages) {
    const auto files = test::robotFiles(language, test::twoLayers(), withLoad());
    const EquippedToolpath read = readEquippedRobotProgram(files, "part");
    EXPECT_EQ(read.equipment.process.count("a tool of 12.5 kg with its centre at -10 0 80.5 mm"), 1U)
        << toString(language);
    EXPECT_EQ(totals(read.toolpath).deposition_runs, 2U);
  }
}

TEST(RobotLoad, NeedsMassAndCentre) {
  RobotProgramSettings settings = withLoad();
  settings.tool_centre_of_gravity_mm.clear();
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings = withLoad();
  settings.tool_mass_kg = 0.0;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
