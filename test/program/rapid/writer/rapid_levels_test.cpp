// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Process values on analogue outputs in RAPID.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "support/rapid_programs.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kPowerLevelPer = 0.0025;
constexpr double kWireLevelPer = 0.04;

RapidSettings withLevels(RapidVariant variant) {
  RapidSettings settings;
  settings.variant = variant;
  settings.levels = "laser_power_w=aoLaser*0.0025, wire_speed_mm_s=aoWire*0.04";
  return settings;
}

/// One open path of three motions at 400, 400 and 500 W.
Toolpath threeMotions() {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{0, 0, 1}, {10, 0, 1}, {20, 0, 1}, {30, 0, 1}};
  path.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
  path.bead = AlongPath<Bead>(Bead{2.0, 1.0});
  path.feed_mm_s = AlongPath<double>(10.0);
  path.values = {{"laser_power_w", AlongPath<double>(std::vector<double>{400, 400, 400, 500})}};
  Toolpath toolpath;
  toolpath.layers.push_back({1.0, 1.0, {path}});
  return toolpath;
}

Toolpath readBackModules(const std::vector<std::string>& texts) {
  std::vector<RapidText> modules;
  modules.reserve(texts.size());
  for (std::size_t m = 0; m < texts.size(); ++m) modules.push_back({"m" + std::to_string(m), texts[m]});
  return readRapid(modules, "part");
}

TEST(RapidLevels, AreSetAtRestAndByTriggersOnTheWay) {
  RapidSettings settings = withLevels(RapidVariant::Powder5Axes);
  settings.levels = "laser_power_w=aoLaser*0.0025";
  const std::vector<std::string> texts = test::rapidModules(threeMotions(), settings);
  EXPECT_NE(texts[0].find("!# level laser_power_w aoLaser 0.0025\n"), std::string::npos) << texts[0];
  EXPECT_NE(texts[0].find("  VAR triggdata lamina_level_1;\n"), std::string::npos);
  EXPECT_NE(texts[0].find("!# value laser_power_w\n"), std::string::npos);
  const std::vector<std::string> lines = test::pointLines(texts);
  ASSERT_EQ(lines.size(), 8U);
  // 400 W is 1 V, from the start on; 500 W is 1.25 V, from the last point but one on.
  EXPECT_EQ(lines[1], "SetAO aoLaser,1;Haz_ON;");
  EXPECT_EQ(lines[2].find("MoveL "), 0U);
  EXPECT_EQ(lines[3], "");
  EXPECT_EQ(lines[5], "TriggIO lamina_level_1,0\\Start\\AOp:=aoLaser,1.25;");
  EXPECT_EQ(lines[6].find("TriggL "), 0U);
  EXPECT_NE(lines[6].find(",speed_prueba,lamina_level_1,fine,"), std::string::npos) << lines[6];
  EXPECT_EQ(lines[7], "Haz_OFF;WaitTime 1.2;SetAO aoLaser,0;");
}

TEST(RapidLevels, AreReadBackWithinTheirDigits) {
  for (const RapidVariant variant :
       {RapidVariant::Powder5Axes, RapidVariant::Powder3Axes, RapidVariant::Wire3Axes})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Toolpath written = test::withValues(test::twoLayers(), seed);
      RapidSettings settings = withLevels(variant);
      settings.has_dry_flag = seed % 3 == 0;
      settings.max_points = seed % 2 == 0 ? 0 : 9;
      const Toolpath read = readBackModules(test::rapidModules(written, settings));
      ASSERT_EQ(read.layers.size(), written.layers.size());
      for (std::size_t l = 0; l < read.layers.size(); ++l) {
        ASSERT_EQ(read.layers[l].paths.size(), written.layers[l].paths.size());
        for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p) {
          const Path& one = written.layers[l].paths[p];
          const Path& other = read.layers[l].paths[p];
          ASSERT_EQ(other.values.size(), one.values.size());
          for (std::size_t v = 0; v < one.values.size(); ++v) {
            EXPECT_EQ(other.values[v].name, one.values[v].name);
            const double per = one.values[v].name == "laser_power_w" ? kPowerLevelPer : kWireLevelPer;
            for (std::size_t m = 0; m < one.motionCount(); ++m)
              EXPECT_NEAR(other.values[v].value.at(one.motionEnd(m)),
                          one.values[v].value.at(one.motionEnd(m)), 0.51e-6 / per);
          }
        }
      }
    }
}

/// A move names its trigger in a dry run too, so that one that sets 0 stands in place of the level's.
TEST(RapidLevels, StayAtZeroInADryRun) {
  RapidSettings settings = withLevels(RapidVariant::Powder5Axes);
  settings.levels = "laser_power_w=aoLaser*0.0025";
  settings.has_dry_flag = true;
  std::vector<std::string> texts = test::rapidModules(threeMotions(), settings);
  const std::vector<std::string> lines = test::pointLines(texts);
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[1], "IF NOT lamina_dry SetAO aoLaser,1;Haz_ON;");
  EXPECT_EQ(lines[5],
            "IF NOT lamina_dry THEN TriggIO lamina_level_1,0\\Start\\AOp:=aoLaser,1.25;ELSE TriggIO "
            "lamina_level_1,0\\Start\\AOp:=aoLaser,0;ENDIF ");
  EXPECT_EQ(lines[7], "Haz_OFF;WaitTime 1.2;SetAO aoLaser,0;");
  const Path read = readBackModules(texts).layers[0].paths[0];
  EXPECT_NEAR(read.values[0].value.at(1), 400.0, 1e-3);
  EXPECT_NEAR(read.values[0].value.at(3), 500.0, 1e-3);
  // What a dry run does instead of the process is to leave outputs off.
  const std::string off = "aoLaser,0;ENDIF";
  texts[0].replace(texts[0].find(off), off.size(), "aoLaser,0.5;ENDIF");
  EXPECT_THROW(readBackModules(texts), InvalidProgram);
}

TEST(RapidLevels, NeedAnOutputForEachValue) {
  RapidSettings settings;
  try {
    test::rapidModules(threeMotions(), settings);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("'laser_power_w'; expected an output for it in rapid.levels"),
              std::string::npos)
        << error.what();
  }
}

TEST(RapidLevels, AreRefusedWhereTheyAreNoneOrCannotBe) {
  for (const char* text : {"laser_power_w", "laser_power_w=aoLaser", "laser_power_w=aoLaser*0", "=aoLaser*1",
                           "laser_power_w=1*2", "a=aoA*1,a=aoB*1", "a=aoA*1,b=aoA*1"})
    EXPECT_THROW(rapidLevels(text), InvalidConfig) << text;
  RapidSettings settings = withLevels(RapidVariant::Powder5Axes);
  settings.process = RapidProcess::Arc;
  EXPECT_THROW(checkedRapidSettings(settings), InvalidConfig);
}

TEST(RapidLevels, OfOutputsThatNoNoteNamesAreRefused) {
  std::vector<std::string> texts = test::rapidModules(threeMotions(), withLevels(RapidVariant::Powder5Axes));
  const std::size_t at = texts[0].find("SetAO aoLaser,1;");
  texts[0].replace(at, 16, "SetAO aoOther,1;");
  try {
    readBackModules(texts);
    FAIL();
  } catch (const InvalidProgram& error) {
    EXPECT_NE(std::string(error.what()).find("found analogue output 'aoother'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace lamina
