// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/writer/robot_printer.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/robot/fanuc/fanuc_printer.hpp"
#include "program/robot/inform/inform_printer.hpp"
#include "program/robot/krl/krl_printer.hpp"
#include "program/robot/urscript/urscript_printer.hpp"

namespace lamina {
namespace {

constexpr double kBeyondFormat = 99999.9995;  // what is rounded to 100000.000
constexpr double kHeldTable = 5e-4;           // deg: what is written as 0.000

}  // namespace

RobotDialect robotDialect(RobotLanguage language, const RobotProgramSettings& settings) {
  switch (language) {
    case RobotLanguage::Krl:
      return krlDialect(settings);
    case RobotLanguage::UrScript:
      return urScriptDialect(settings);
    case RobotLanguage::Fanuc:
      return fanucDialect(settings);
    case RobotLanguage::Inform:
      return informDialect(settings);
  }
  throw InvalidConfig("there is no language number " + std::to_string(static_cast<int>(language)));
}

ControllerMap controllerMap(RobotLanguage language, const RobotProgramSettings& settings) {
  requireConsistent(settings);
  ControllerMap map;
  std::copy(settings.joint_signs.begin(), settings.joint_signs.end(), map.signs.begin());
  std::copy(settings.joint_zeros_deg.begin(), settings.joint_zeros_deg.end(), map.zeros_deg.begin());
  if (language == RobotLanguage::Fanuc) map.joint_3_from_2 = settings.fanuc.joint_3_from_2;
  map.external = robotExternals(settings.external_axes);
  return map;
}

void requireProgramName(const std::string& name, std::size_t longest, RobotLanguage language) {
  const bool is_name =
      !name.empty() && name.size() <= longest && isLetter(name.front()) &&
      std::all_of(name.begin(), name.end(), [](char c) { return isLetter(c) || isDigit(c) || c == '_'; });
  if (!is_name)
    throw InvalidConfig("the program's name is '" + name +
                        "' (robot_program.name, or that of the file); must be a " +
                        "letter, then letters, digits and underscores, at most " + std::to_string(longest) +
                        " in " + toString(language));
}

void requireFreeName(const std::string& name, const std::vector<std::string_view>& reserved,
                     RobotLanguage language) {
  std::string small = name;
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (std::find(reserved.begin(), reserved.end(), small) != reserved.end())
    throw InvalidConfig("the program's name is '" + name +
                        "' (robot_program.name, or that of the file), a word of " + toString(language) +
                        " itself; expected another");
}

void requireNoDrySpeed(const RobotProgramSettings& settings, RobotLanguage language) {
  if (settings.dry_speed_percent < 100.0)
    throw InvalidConfig("robot_program.dry_speed_percent is " + numberText(settings.dry_speed_percent) +
                        "; expected 100 in " + toString(language) +
                        ", whose dry runs go at the override of the pendant");
}

void requireInFormat(double value, const char* unit, RobotLanguage language) {
  if (!(std::abs(value) < kBeyondFormat))
    throw InvalidInput("a coordinate is " + numberText(value) + " " + unit +
                       "; must be within -99999.999 to 99999.999 " + unit + " in " + toString(language));
}

void requireSchedule(const char* key, int schedule) {
  if (schedule == 0)
    throw InvalidConfig(
        std::string(key) +
        " is 0 with robot_program.process 'schedules'; expected the number of a schedule that "
        "the controller holds");
}

void requireSchedules(const ArcSettings& arc) {
  if (arc.process == RobotProcess::Outputs) return;
  requireSchedule("robot_program.start_schedule", arc.start_schedule);
  requireSchedule("robot_program.end_schedule", arc.end_schedule);
}

void requireOutputNumber(int output, RobotLanguage language) {
  if (output < 1)
    throw InvalidInput("found output " + std::to_string(output) + "; expected 1 at least, from which " +
                       toString(language) + " counts (robot_program.process_output, robot_program.levels)");
}

void requireHeldTable(const std::vector<double>& external, const RobotSite& site,
                      const StandingFrame& frame) {
  if (!site.cell || !site.cell->is_bed_carried) return;
  const std::vector<ExternalEntry>& entries = site.map.external;
  for (std::size_t k = 0; k < external.size(); ++k) {
    const double zero = entries.empty() ? 0.0 : entries[k].zero;
    if (site.external[k] != JointKind::Rotary || std::abs(external[k] - zero) <= kHeldTable) continue;
    const std::string joint = entries.empty() ? "external_" + std::to_string(k + 1) : entries[k].joint;
    throw InvalidInput(frame.why + ", and axis " + joint + " turns the bed to " + numberText(external[k]) +
                       " deg; expected " + frame.remedy + ", or " + numberText(zero) +
                       " deg (joints.external 'held')");
  }
}

std::vector<double> waitParts(double duration_s, double longest_s) {
  std::vector<double> parts;
  for (; duration_s > longest_s; duration_s -= longest_s) parts.push_back(longest_s);
  parts.push_back(duration_s);
  return parts;
}

std::string upperCaseName(const std::string& name) {
  std::string upper = name;
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

std::string plainText(const std::string& text) {
  std::string plain = text;
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return plain;
}

}  // namespace lamina
