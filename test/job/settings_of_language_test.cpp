// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings_of_language.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// What a job is refused with; empty if it is not.
std::string languageRefusal(const SliceJob& job) {
  try {
    requireSettingsOfLanguage(job);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

TEST(SettingsOfLanguage, ADryRunAskedOfAnotherLanguageIsRefused) {
  SliceJob job;
  job.settings.program.robot.dry_flag = 3;
  job.output = "a.mod";
  EXPECT_EQ(languageRefusal(job),
            "robot_program.dry_flag is 3, but 'a.mod' is a program in RAPID, which has no use for it; "
            "expected 0, or also rapid.dry_flag true");
  job.settings.program.rapid.has_dry_flag = true;
  for (const char* output : {"a.mod", "a.src", "a.csv", "a.gcode", ""}) {
    job.output = output;
    EXPECT_EQ(languageRefusal(job), "") << output;
  }
  job.settings.program.robot.dry_flag = 0;
  for (const char* output : {"a.src", "a.script", "a.ls", "a.jbi"}) {
    job.output = output;
    EXPECT_NE(languageRefusal(job).find("rapid.dry_flag is true, but"), std::string::npos) << output;
  }
}

TEST(SettingsOfLanguage, AnArcAskedOfAnotherLanguageIsRefused) {
  SliceJob job;
  job.settings.program.robot.arc.process = RobotProcess::Schedules;
  job.output = "a.mod";
  EXPECT_NE(
      languageRefusal(job).find("robot_program.process is 'schedules', but 'a.mod' is a program in RAPID"),
      std::string::npos);
  job.settings.program.rapid.process = RapidProcess::Arc;
  EXPECT_EQ(languageRefusal(job), "");
  job.settings.program.robot.arc.process = RobotProcess::Outputs;
  job.output = "a.ls";
  EXPECT_NE(languageRefusal(job).find("expected 'outputs', or also robot_program.process 'schedules'"),
            std::string::npos);
}

TEST(SettingsOfLanguage, TemperaturesOfRobotsAreNamed) {
  SliceJob job;
  job.settings.program.nozzle_temperature_c = 230.0;
  for (const char* output : {"a.mod", "a.src", "a.script", "a.ls", "a.jbi"}) {
    job.output = output;
    EXPECT_EQ(noteOnOtherLanguages(job).find("program.nozzle_temperature_c has no effect on a program in "),
              0U)
        << output;
  }
  job.output = "a.gcode";
  EXPECT_EQ(noteOnOtherLanguages(job), "");
  job.output = "a.src";
  job.settings.program.nozzle_temperature_c = 0.0;
  EXPECT_EQ(noteOnOtherLanguages(job), "") << "a heater that is left alone";
}

TEST(SettingsOfLanguage, OthersAreNamed) {
  SliceJob job;
  for (const char* output : {"a.mod", "a.src", "a.ls", "a.csv"}) {
    job.output = output;
    EXPECT_EQ(noteOnOtherLanguages(job), "") << "all by default: " << output;
  }
  job.settings.program.robot.levels = "laser_power_w=1*0.001";
  job.settings.program.robot.approach_mm = 20.0;
  job.output = "a.mod";
  EXPECT_EQ(noteOnOtherLanguages(job),
            "robot_program.approach_mm, robot_program.levels have no effect on a program in RAPID");
  job.output = "a.src";
  EXPECT_EQ(noteOnOtherLanguages(job), "");
  job.settings.program.robot.fanuc.cnt = 50;
  EXPECT_EQ(noteOnOtherLanguages(job), "fanuc.cnt has no effect on a program in KRL");
  job.settings.program.robot.fanuc.cnt = 100;
  job.settings.program.robot.corner_mm = 0.0;
  EXPECT_EQ(noteOnOtherLanguages(job), "");
  for (const char* output : {"a.ls", "a.jbi"}) {
    job.output = output;
    EXPECT_EQ(noteOnOtherLanguages(job).find("robot_program.corner_mm has no effect on a program in"), 0U);
  }
  job.output = "a.csv";
  EXPECT_EQ(noteOnOtherLanguages(job), "") << "no program of a robot";
}

TEST(SettingsOfLanguage, AreJudgedBeforeThePartIsReadAndNamedInTheSummary) {
  const test::ScratchFolder folder;
  SliceJob job;
  NoProgress nobody;
  job.part = folder.file("box.stl");
  job.output = folder.file("a.mod");
  job.settings.machine.name = "irb_4600";
  job.settings.program.robot.dry_flag = 3;
  EXPECT_THROW(runSliceJob(job, nobody), InvalidConfig) << "there is no part";
  job.settings.program.robot.dry_flag = 0;
  job.settings.program.robot.corner_mm = 0.0;
  job.output = folder.file("A.ls");
  job.settings.slicing.layer_height_mm = 0.5;
  job.settings.slicing.first_layer_height_mm = 0.5;
  writeStl(job.part, test::boxBetween({0, 0, 0}, {12, 8, 0.5}));
  const std::vector<std::string> notes = runSliceJob(job, nobody).summary.notes;
  EXPECT_EQ(std::count(notes.begin(), notes.end(),
                       "robot_program.corner_mm has no effect on a program in Fanuc TP"),
            1);
}

}  // namespace
}  // namespace lamina
