// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The variable that runs a program without its process, in each language.
#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "support/rapid_programs.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::robotFiles;

std::size_t timesIn(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

/// The text with the first place of a part replaced.
std::string replacedIn(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

RobotProgramSettings withDryFlag() {
  RobotProgramSettings settings;
  settings.dry_flag = 3;
  settings.process_lead_s = 0.5;
  return settings;
}

class DryFlag : public testing::TestWithParam<RobotLanguage> {
 protected:
  /// What stands round the statement that starts the process.
  std::string startOf(int number) const {
    const std::string label = std::to_string(number);
    switch (GetParam()) {
      case RobotLanguage::Krl:
        return "IF NOT $FLAG[3] THEN\n$OUT[1]=TRUE\nENDIF\n";
      case RobotLanguage::UrScript:
        return "  if not lamina_dry:\n    set_standard_digital_out(1, True)\n  end\n";
      case RobotLanguage::Fanuc:
        return "";  // lines are numbered
      case RobotLanguage::Inform:
        return "JUMP *DRY" + label + " IF B003<>0\r\nDOUT OT#(1) ON\r\n*DRY" + label + "\r\n";
    }
    return "";
  }
};

TEST_P(DryFlag, StandsBeforeEachStartOfTheProcessAndNowhereElse) {
  const std::string text = robotFiles(GetParam(), test::twoLayers(), withDryFlag())[0].text;
  if (GetParam() == RobotLanguage::Fanuc) {
    EXPECT_EQ(timesIn(text, ":  IF R[3]<>0,JMP LBL[1] ;\n  13:  DO[1]=ON ;\n  14:  LBL[1] ;\n"), 1U) << text;
    EXPECT_EQ(timesIn(text, "JMP LBL["), 2U);
  } else {
    EXPECT_EQ(timesIn(text, startOf(1)) + timesIn(text, startOf(2)),
              GetParam() == RobotLanguage::Inform ? 2U : 4U)
        << text;
  }
  EXPECT_EQ(timesIn(text, "global lamina_dry = False"), GetParam() == RobotLanguage::UrScript ? 1U : 0U);
}

TEST_P(DryFlag, IsReadBackWithTheSameToolpath) {
  const Toolpath toolpath = test::withValues(test::twoLayers(), 7);
  RobotProgramSettings settings = withDryFlag();
  settings.levels = "laser_power_w=1*0.0025, wire_speed_mm_s=0*0.03";
  if (GetParam() != RobotLanguage::UrScript)
    settings.levels = "laser_power_w=1*0.0025, wire_speed_mm_s=2*0.03";
  const auto dry = readEquippedRobotProgram(robotFiles(GetParam(), toolpath, settings), "part");
  settings.dry_flag = 0;
  const auto plain = readEquippedRobotProgram(robotFiles(GetParam(), toolpath, settings), "part");
  ASSERT_EQ(totals(dry.toolpath).waypoints, totals(plain.toolpath).waypoints);
  EXPECT_EQ(totals(dry.toolpath).deposition_mm, totals(plain.toolpath).deposition_mm);
  ASSERT_EQ(dry.toolpath.layers[0].paths[0].values.size(), plain.toolpath.layers[0].paths[0].values.size());
  EXPECT_EQ(dry.toolpath.layers[0].paths[0].values[0].value.at(1),
            plain.toolpath.layers[0].paths[0].values[0].value.at(1));
  EXPECT_EQ(dry.equipment.process.count("dry run by variable 3"), 1U);
  EXPECT_EQ(plain.equipment.process.count("dry run by variable 3"), 0U);
}

// A look at a variable of the controller may stop it from looking ahead: amid a bead the tip would stop.
TEST(DryFlagOfKrl, IsReadAtRestForLevelsThatChangeOnTheWay) {
  RobotProgramSettings settings = withDryFlag();
  settings.levels = "laser_power_w=1*0.0025, wire_speed_mm_s=2*0.01";
  const std::string text =
      robotFiles(RobotLanguage::Krl, test::withValues(test::twoLayers(), 1), settings)[0].text;
  EXPECT_EQ(timesIn(text, "()\nDECL BOOL lamina_dry\n"), 1U) << text;
  EXPECT_EQ(timesIn(text, "\nlamina_dry=$FLAG[3]\nIF NOT $FLAG[3] THEN\n$OUT[1]=TRUE\nENDIF\n"),
            timesIn(text, "$OUT[1]=TRUE"));
  EXPECT_GT(timesIn(text, "TRIGGER"), 0U);
  EXPECT_EQ(timesIn(text, "\nIF NOT lamina_dry THEN\nTRIGGER "), timesIn(text, "TRIGGER"));
  // Without such levels the program is as it was.
  settings.levels.clear();
  EXPECT_EQ(timesIn(robotFiles(RobotLanguage::Krl, test::twoLayers(), settings)[0].text, "lamina_dry"), 0U);
}

TEST_P(DryFlag, IsRefusedRoundAnythingButTheProcess) {
  RobotFile file = robotFiles(GetParam(), test::twoLayers(), withDryFlag())[0];
  switch (GetParam()) {
    case RobotLanguage::Krl:
      file.text = replacedIn(file.text, "$OUT[1]=TRUE\nENDIF\n", "$OUT[1]=TRUE\n");
      break;
    case RobotLanguage::UrScript:
      file.text = replacedIn(file.text, "True)\n  end\n", "True)\n");
      break;
    case RobotLanguage::Fanuc:
      file.text = replacedIn(file.text, ":  LBL[1] ;\n", ":  LBL[2] ;\n");
      break;
    case RobotLanguage::Inform:
      file.text = replacedIn(file.text, "DOUT OT#(1) ON", "DOUT OT#(1) OFF");
      break;
  }
  EXPECT_THROW(readRobotProgram({file}, "part"), InvalidProgram);
}

TEST_P(DryFlag, IsRefusedWithSchedulesOfTheArcPackage) {
  RobotProgramSettings settings = withDryFlag();
  settings.arc.process = RobotProcess::Schedules;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

INSTANTIATE_TEST_SUITE_P(Languages, DryFlag,
                         testing::Values(RobotLanguage::Krl, RobotLanguage::UrScript, RobotLanguage::Fanuc,
                                         RobotLanguage::Inform));

RobotProgramSettings withDrySpeed() {
  RobotProgramSettings settings = withDryFlag();
  settings.dry_speed_percent = 20.0;
  return settings;
}

TEST(DrySpeed, IsAShareOfEachSpeedInKrl) {
  const std::string text = robotFiles(RobotLanguage::Krl, test::twoLayers(), withDrySpeed())[0].text;
  EXPECT_EQ(timesIn(text, "()\nDECL REAL lamina_speed\n"), 1U) << text;
  EXPECT_EQ(timesIn(text, "\nlamina_speed=1.0\nIF $FLAG[3] THEN\nlamina_speed=0.2\nENDIF\n"), 1U) << text;
  EXPECT_GT(timesIn(text, "$VEL.CP="), 0U);
  EXPECT_EQ(timesIn(text, "*lamina_speed\n"), timesIn(text, "$VEL.CP="));
}

TEST(DrySpeed, IsAShareOfEachSpeedInUrScript) {
  const std::string text = robotFiles(RobotLanguage::UrScript, test::twoLayers(), withDrySpeed())[0].text;
  EXPECT_EQ(timesIn(text,
                    "  global lamina_dry = False\n  global lamina_speed = 1.0\n  if lamina_dry:\n"
                    "    lamina_speed = 0.2\n  end\n"),
            1U)
      << text;
  EXPECT_EQ(timesIn(text, "*lamina_speed, r="), timesIn(text, "movel(") + timesIn(text, "movep("));
}

TEST(DrySpeed, LeavesTheSpeedsThatAreReadBack) {
  for (const RobotLanguage language : {RobotLanguage::Krl, RobotLanguage::UrScript}) {
    const auto slow =
        readEquippedRobotProgram(robotFiles(language, test::twoLayers(), withDrySpeed()), "part");
    const auto plain =
        readEquippedRobotProgram(robotFiles(language, test::twoLayers(), withDryFlag()), "part");
    EXPECT_EQ(slow.toolpath.layers[0].paths[0].feed_mm_s.at(1),
              plain.toolpath.layers[0].paths[0].feed_mm_s.at(1));
    EXPECT_EQ(totals(slow.toolpath).deposition_mm, totals(plain.toolpath).deposition_mm);
    EXPECT_EQ(slow.equipment.process.count("dry run at 20 % of the speed"), 1U);
    EXPECT_EQ(plain.equipment.process.count("dry run at 20 % of the speed"), 0U);
  }
}

TEST(DrySpeed, StandsAloneUnderItsCondition) {
  RobotFile krl = robotFiles(RobotLanguage::Krl, test::twoLayers(), withDrySpeed())[0];
  krl.text = replacedIn(krl.text, "lamina_speed=0.2\n", "$OUT[1]=TRUE\n");
  EXPECT_THROW(readRobotProgram({krl}, "part"), InvalidProgram);
  RobotFile script = robotFiles(RobotLanguage::UrScript, test::twoLayers(), withDrySpeed())[0];
  script.text =
      replacedIn(script.text, "    lamina_speed = 0.2\n", "    set_standard_digital_out(1, True)\n");
  EXPECT_THROW(readRobotProgram({script}, "part"), InvalidProgram);
}

TEST(DrySpeed, NeedsAFlagAndALanguageOfVariables) {
  RobotProgramSettings settings = withDrySpeed();
  for (const RobotLanguage language : {RobotLanguage::Fanuc, RobotLanguage::Inform})
    EXPECT_THROW(robotFiles(language, test::twoLayers(), settings), InvalidConfig);
  settings.dry_flag = 0;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

TEST(RapidDryFlag, IsTestedByTheProceduresThatStartTheProcess) {
  RapidSettings settings;
  settings.variant = RapidVariant::Powder5Axes;
  settings.has_dry_flag = true;
  const std::string text = test::rapidModules(test::twoLayers(), settings)[0];
  EXPECT_EQ(timesIn(text, "  PERS bool lamina_dry:=FALSE;\n"), 1U);
  EXPECT_EQ(timesIn(text, "  PROC Haz_ON()\n    IF NOT lamina_dry Set SolicitudLaser;\n  ENDPROC\n"), 1U);
  EXPECT_EQ(timesIn(text, "    IF NOT lamina_dry Set SolicitudGas;IF NOT lamina_dry Set SolicitudPolvo;\n"),
            1U);
  EXPECT_EQ(timesIn(text, "IF NOT"), 3U);
  settings.has_dry_flag = false;
  const std::string plain = test::rapidModules(test::twoLayers(), settings)[0];
  EXPECT_EQ(totals(readRapid({{"a.mod", text}}, "part")).deposition_mm,
            totals(readRapid({{"a.mod", plain}}, "part")).deposition_mm);
  EXPECT_EQ(readEquippedRapid({{"a.mod", text}}, "part").equipment.process.count("the flag lamina_dry"), 1U);
}

TEST(RapidDryFlag, PassesOverTheWaitForALaserThatIsNotAskedFor) {
  RapidSettings settings;
  settings.variant = RapidVariant::Wire3Axes;
  settings.has_dry_flag = true;
  const std::string text = test::rapidModules(test::twoLayers(), settings)[0];
  EXPECT_EQ(timesIn(text, "IF NOT lamina_dry THEN WaitDI LaserON,high;"), 2U) << text;
  EXPECT_EQ(timesIn(text, "WaitTime waiting2;ENDIF "), 2U);
  settings.has_dry_flag = false;
  const std::string plain = test::rapidModules(test::twoLayers(), settings)[0];
  EXPECT_EQ(totals(readRapid({{"a.mod", text}}, "part")).deposition_mm,
            totals(readRapid({{"a.mod", plain}}, "part")).deposition_mm);
  EXPECT_THROW(
      readRapid({{"a.mod", replacedIn(text, "WaitTime waiting2;ENDIF ", "WaitTime waiting2;")}}, "part"),
      InvalidProgram);
}

TEST(RapidDryFlag, MayGoWithASpeedOfItsOwn) {
  for (const RapidVariant variant : {RapidVariant::Powder5Axes, RapidVariant::Wire3Axes}) {
    RapidSettings settings;
    settings.variant = variant;
    settings.has_dry_flag = true;
    const std::string plain = test::rapidModules(test::twoLayers(), settings)[0];
    settings.dry_speed_percent = 20.0;
    const std::string text = test::rapidModules(test::twoLayers(), settings)[0];
    EXPECT_EQ(timesIn(text, "  PROC main()\n    IF lamina_dry VelSet 20,5000;\n"), 1U) << text;
    EXPECT_EQ(timesIn(text, "    IF lamina_dry VelSet 100,5000;\n  ENDPROC\n"), 1U) << text;
    const auto read = readEquippedRapid({{"a.mod", text}}, "part");
    const auto read_plain = readEquippedRapid({{"a.mod", plain}}, "part");
    EXPECT_EQ(toolpathId(read.toolpath), toolpathId(read_plain.toolpath));
    EXPECT_EQ(read.equipment.process.count("dry run at 20 % of the speed"), 1U);
    EXPECT_EQ(read_plain.equipment.process.count("dry run at 20 % of the speed"), 0U);
    EXPECT_THROW(
        readRapid({{"a.mod", replacedIn(text, "IF lamina_dry VelSet 20,5000", "IF lamina_dry Set DO1")}},
                  "part"),
        InvalidProgram);
    settings.has_dry_flag = false;
    EXPECT_THROW(checkedRapidSettings(settings), InvalidConfig);
  }
}

TEST(RapidDryFlag, IsRefusedWithArcs) {
  RapidSettings settings;
  settings.has_dry_flag = true;
  settings.process = RapidProcess::Arc;
  EXPECT_THROW(checkedRapidSettings(settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
