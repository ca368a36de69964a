// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings_of_language.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"

namespace lamina {
namespace {

using LanguageSet = std::vector<RobotLanguage>;

/// What settings begin with, or are, and the languages that use them. Whole keys come first.
const std::vector<std::pair<std::string, LanguageSet>>& usedBy() {
  static const std::vector<std::pair<std::string, LanguageSet>> all = {
      {"robot_program.corner_mm", {RobotLanguage::Krl, RobotLanguage::UrScript}},
      {"robot_program.date", {RobotLanguage::Fanuc, RobotLanguage::Inform}},
      {"robot_program.frame_number", {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform}},
      {"robot_program.tool_number", {RobotLanguage::Krl, RobotLanguage::Fanuc, RobotLanguage::Inform}},
      {"robot_program.", {kRobotLanguages.begin(), kRobotLanguages.end()}},
      {"krl.", {RobotLanguage::Krl}},
      {"urscript.", {RobotLanguage::UrScript}},
      {"fanuc.", {RobotLanguage::Fanuc}},
      {"inform.", {RobotLanguage::Inform}}};
  return all;
}

bool isUsed(const std::string& key, const std::optional<RobotLanguage>& language) {
  if (!language)
    return key.rfind("rapid.", 0) == 0 || key == "robot_program.tool_mass_kg" ||
           key == "robot_program.tool_centre_of_gravity_mm";
  const auto found = std::find_if(usedBy().begin(), usedBy().end(),
                                  [&](const auto& each) { return key.rfind(each.first, 0) == 0; });
  if (found == usedBy().end()) return false;
  return std::count(found->second.begin(), found->second.end(), *language) > 0;
}

/// Keys of the settings that differ from their defaults.
template <class Settings>
std::vector<std::string> changedKeys(Settings settings) {
  Settings plain;
  SettingsSchema own;
  SettingsSchema defaults;
  describe(own, settings);
  describe(defaults, plain);
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < own.settings().size(); ++i)
    if (own.settings()[i].get() != defaults.settings()[i].get()) keys.push_back(own.settings()[i].key);
  return keys;
}

/// Temperatures that are asked for: no robot's program sets one, or waits for one.
std::vector<std::string> temperatureKeys(const ProgramSettings& program) {
  const ProgramSettings plain;
  const auto isAsked = [](double value, double by_default) { return value > 0.0 && value != by_default; };
  std::vector<std::string> keys;
  if (isAsked(program.nozzle_temperature_c, plain.nozzle_temperature_c))
    keys.emplace_back("program.nozzle_temperature_c");
  if (isAsked(program.bed_temperature_c, plain.bed_temperature_c))
    keys.emplace_back("program.bed_temperature_c");
  return keys;
}

/// What may stand in place of a setting of another language.
struct Misplaced {
  const char* expected;  ///< value of that setting by which nothing is asked for
  const char* own;       ///< setting of the program's own language that asks for the same
};

[[noreturn]] void refuseMisplaced(const SliceJob& job, const std::string& what, const Misplaced& misplaced) {
  throw InvalidConfig(what + ", but '" + job.output + "' is a program in " + robotLanguageName(job.output) +
                      ", which has no use for it; expected " + misplaced.expected + ", or also " +
                      misplaced.own);
}

}  // namespace

void requireSettingsOfLanguage(const SliceJob& job) {
  const RapidSettings& rapid = job.settings.program.rapid;
  const RobotProgramSettings& robot = job.settings.program.robot;
  const bool has_schedules = robot.arc.process == RobotProcess::Schedules;
  const bool has_arc = rapid.process == RapidProcess::Arc;
  switch (programRunner(job.output)) {
    case ProgramRunner::RapidRobot:
      if (robot.dry_flag > 0 && !rapid.has_dry_flag)
        refuseMisplaced(job, "robot_program.dry_flag is " + std::to_string(robot.dry_flag),
                        {"0", "rapid.dry_flag true"});
      if (has_schedules && !has_arc)
        refuseMisplaced(job, "robot_program.process is 'schedules'", {"'outputs'", "rapid.process 'arc'"});
      return;
    case ProgramRunner::OtherRobot:
      if (rapid.has_dry_flag && robot.dry_flag == 0)
        refuseMisplaced(job, "rapid.dry_flag is true",
                        {"false", "robot_program.dry_flag, the number of a variable"});
      if (has_arc && !has_schedules)
        refuseMisplaced(job, "rapid.process is 'arc'", {"'outputs'", "robot_program.process 'schedules'"});
      return;
    default:
      return;
  }
}

std::string noteOnOtherLanguages(const SliceJob& job) {
  if (!isRobotFile(job.output)) return "";
  const std::optional<RobotLanguage> language = robotLanguageOf(job.output);
  std::vector<std::string> keys = changedKeys(job.settings.program.rapid);
  const std::vector<std::string> of_others = changedKeys(job.settings.program.robot);
  keys.insert(keys.end(), of_others.begin(), of_others.end());
  keys.erase(
      std::remove_if(keys.begin(), keys.end(), [&](const std::string& key) { return isUsed(key, language); }),
      keys.end());
  for (std::string& key : temperatureKeys(job.settings.program)) keys.push_back(std::move(key));
  if (keys.empty()) return "";
  return listed(keys) + (keys.size() == 1 ? " has" : " have") + " no effect on a program in " +
         robotLanguageName(job.output);
}

}  // namespace lamina
