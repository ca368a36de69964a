// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_program_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "program/robot/robot_cell.hpp"

namespace lamina {
namespace {

struct LanguageName {
  RobotLanguage language;
  const char* name;
  const char* suffix;
};

constexpr std::array<LanguageName, 4> kLanguages = {{{RobotLanguage::Krl, "KRL", ".src"},
                                                     {RobotLanguage::UrScript, "URScript", ".script"},
                                                     {RobotLanguage::Fanuc, "Fanuc TP", ".ls"},
                                                     {RobotLanguage::Inform, "INFORM", ".jbi"}}};

const LanguageName& nameOf(RobotLanguage language) {
  return *std::find_if(kLanguages.begin(), kLanguages.end(),
                       [&](const LanguageName& each) { return each.language == language; });
}

void describeKrl(SettingsSchema& schema, KrlSettings& settings) {
  schema.choice<KrlPoints>(
      "krl.points", settings.points, {{"inline", KrlPoints::Inline}, {"dat", KrlPoints::Dat}},
      "Points stand in the moves, or by name in the data file (.dat) beside the program.");
  schema.integer("krl.advance", settings.advance, {0, 5}, "Moves that the controller looks ahead: $ADVANCE.");
  schema.number("krl.turn_speed_deg_s", settings.turn_speed_deg_s, Bounds::above(0.0, 1000.0),
                "Speed at which the tool turns: $VEL.ORI1 and $VEL.ORI2.");
  schema.number("krl.acceleration_m_s2", settings.acceleration_m_s2, Bounds::above(0.0, 50.0),
                "Acceleration of the tip: $ACC.CP.");
  schema.text("krl.arc_on", settings.arc_on,
              "Statement of the arc package that starts the arc, as ARC_ON({schedule},{weave}).");
  schema.text("krl.arc_off", settings.arc_off, "Statement that ends it, as ARC_OFF({schedule}).");
  schema.integer("krl.max_lines", settings.max_lines, {100, 1e6}, "Lines in a file of KRL at most.");
  schema.number("krl.max_mb", settings.max_mb, {0.1, 1000.0},
                "Memory of the controller that all files of a program may take, in 10^6 bytes.");
}

void describeArc(SettingsSchema& schema, ArcSettings& arc) {
  schema.choice<RobotProcess>(
      "robot_program.process", arc.process,
      {{"outputs", RobotProcess::Outputs}, {"schedules", RobotProcess::Schedules}},
      "Whether the process is switched by outputs, or by statements of the arc package that name schedules.");
  schema.integer("robot_program.start_schedule", arc.start_schedule, {0, 999},
                 "Schedule on the controller by which an arc starts; 0 for none, which no arc can start by.");
  schema.integer("robot_program.end_schedule", arc.end_schedule, {0, 999},
                 "Schedule on the controller by which an arc ends; 0 for none, which no arc can end by.");
  schema.integer("robot_program.weave_schedule", arc.weave_schedule, {0, 999},
                 "Schedule on the controller by which it weaves while the arc burns; 0 for none.");
}

void describeUrScript(SettingsSchema& schema, UrScriptSettings& settings) {
  schema.choice<UrBeadMove>("urscript.bead_move", settings.bead_move,
                            {{"movep", UrBeadMove::MoveP}, {"movel", UrBeadMove::MoveL}},
                            "Statement that lays beads: movep keeps the tip's speed round corners.");
  schema.number("urscript.acceleration_m_s2", settings.acceleration_m_s2, Bounds::above(0.0, 50.0),
                "Acceleration of the tip.");
  schema.number("urscript.joint_acceleration_rad_s2", settings.joint_acceleration_rad_s2,
                Bounds::above(0.0, 100.0), "Acceleration of the move of the joints.");
  schema.integer("urscript.max_points", settings.max_points, {4, 1e6}, "Points in a script at most.");
}

const std::vector<std::pair<std::string, JointSign>>& jointSigns() {
  static const std::vector<std::pair<std::string, JointSign>> signs = {{"positive", JointSign::Positive},
                                                                       {"negative", JointSign::Negative}};
  return signs;
}

void describeFanuc(SettingsSchema& schema, FanucSettings& settings) {
  schema.integer("fanuc.cnt", settings.cnt, {0, 100}, "CNT of points that may be rounded.");
  schema.number(
      "fanuc.joint_3_from_2", settings.joint_3_from_2, {-1.0, 1.0},
      "Share of joint 2 in what the controller counts of joint 3: -1 where it counts the forearm from "
      "level, 0 where from the upper arm.");
  schema.choice<JointSign>("fanuc.flip", settings.flip, jointSigns(),
                           "Sign of joint 5 with which CONFIG says F.");
  schema.list("fanuc.turn_axes", settings.turn_axes, {1.0, 6.0},
              "Joints whose whole turns CONFIG counts, in their order.");
  schema.integer("fanuc.name_length", settings.name_length, {1, 36},
                 "Characters of a program's name at most: 8 on older controllers.");
  schema.integer("fanuc.max_lines", settings.max_lines, {100, 9999}, "Lines in a listing at most.");
  schema.integer(
      "fanuc.arc_equipment", settings.arc_equipment, {0, 5},
      "Welding equipment that /APPL names where robot_program.process is schedules; 0 for no /APPL.");
  schema.choice<FanucWeldSpeed>(
      "fanuc.weld_speed", settings.weld_speed,
      {{"stated", FanucWeldSpeed::Stated}, {"schedule", FanucWeldSpeed::Schedule}},
      "Whether beads state their speed, or go at WELD_SPEED, that of the schedule on the controller.");
  schema.flag("fanuc.coordinated", settings.is_coordinated,
              "Whether motions over a bed that a positioner turns are COORD: their points are where the bed "
              "is turned to. Without it the controller takes them over a frame that stands still.");
  schema.integer("fanuc.positioner_frame", settings.positioner_frame, {0, 99},
                 "Number of the user frame of group 2, the positioner.");
  schema.integer("fanuc.positioner_tool", settings.positioner_tool, {0, 99},
                 "Number of the tool of group 2, the positioner.");
  schema.integer("fanuc.payload", settings.payload, {0, 10},
                 "Payload on the controller that a listing chooses with its tool, PAYLOAD[n]; 0 for the one "
                 "that the controller has.");
}

void describeInform(SettingsSchema& schema, InformSettings& settings) {
  schema.choice<InformSpeedUnit>(
      "inform.speed_unit", settings.speed_unit,
      {{"mm_s", InformSpeedUnit::MillimetresPerSecond}, {"cm_min", InformSpeedUnit::CentimetresPerMinute}},
      "Unit of V, which a parameter of the controller sets.");
  schema.integer("inform.corner_level", settings.corner_level, {0, 8}, "PL of points that may be rounded.");
  schema.numbers(
      "inform.pulses_per_deg", settings.pulses_per_deg, 6,
      "Pulses of each joint in a degree, from the controller's parameters; empty: joint moves go to poses.");
  schema.list(
      "inform.external_pulses", settings.external_pulses, {-1e6, 1e6},
      "Pulses of each external axis in a mm or a degree, from the controller's parameters, in the order "
      "of the controller; empty where the arm has none.");
  schema.flag("inform.coordinated", settings.is_coordinated,
              "Whether motions over a bed that a station turns are SMOVL: their points are where the bed is "
              "turned to. Without it the controller takes them over a frame that stands still.");
  schema.choice<JointSign>("inform.flip", settings.flip, jointSigns(),
                           "Sign of joint 5 with which RCONF says flip, 0.");
  schema.choice<InformRconfOrder>("inform.rconf_order", settings.rconf_order,
                                  {{"flip_elbow_front", InformRconfOrder::FlipElbowFront},
                                   {"front_elbow_flip", InformRconfOrder::FrontElbowFlip}},
                                  "Order of the first three numbers of RCONF.");
  schema.integer("inform.rconf_length", settings.rconf_length, {6, 24}, "Numbers in RCONF: 6, 8 or 24.");
  schema.choice<InformFrameMark>("inform.frame_mark", settings.frame_mark,
                                 {{"four", InformFrameMark::Four}, {"three", InformFrameMark::Three}},
                                 "Slashes before FRAME.");
  schema.integer("inform.name_length", settings.name_length, {1, 32},
                 "Characters of a job's name at most: 8 on older controllers.");
  schema.integer("inform.max_points", settings.max_points, {4, 9999}, "Points in a job at most.");
}

void requirePulses(const std::string& key, const std::vector<double>& pulses, const char* expected) {
  if (std::find(pulses.begin(), pulses.end(), 0.0) != pulses.end())
    throw InvalidConfig(key + " holds 0; must be " + expected);
}

/// "2000-01-31".
void requireDate(const std::string& date) {
  const auto isDigits = [&](std::size_t begin, std::size_t end) {
    return std::all_of(date.begin() + static_cast<std::ptrdiff_t>(begin),
                       date.begin() + static_cast<std::ptrdiff_t>(end),
                       [](char c) { return c >= '0' && c <= '9'; });
  };
  const bool is_date = date.size() == 10 && date[4] == '-' && date[7] == '-' && isDigits(0, 4) &&
                       isDigits(5, 7) && isDigits(8, 10);
  const int month = is_date ? std::stoi(date.substr(5, 2)) : 0;
  const int day = is_date ? std::stoi(date.substr(8, 2)) : 0;
  if (month < 1 || month > 12 || day < 1 || day > 31)
    throw InvalidConfig("robot_program.date is '" + date + "'; must be a date as 2000-01-31");
}

RobotLevel levelOf(std::string_view entry) {
  const auto refuse = [&]() -> RobotLevel {
    throw InvalidConfig("robot_program.levels holds '" + std::string(entry) +
                        "'; must be name=output*per, as laser_power_w=1*0.0025");
  };
  const auto number = [&](std::string_view text, auto& value) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size()) refuse();
  };
  const std::size_t equals = entry.find('=');
  const std::size_t star = entry.find('*');
  if (equals == std::string_view::npos || star == std::string_view::npos || star < equals) return refuse();
  RobotLevel level;
  level.name = std::string(trimmed(entry.substr(0, equals)));
  number(trimmed(entry.substr(equals + 1, star - equals - 1)), level.output);
  number(trimmed(entry.substr(star + 1)), level.per);
  const bool is_word = !level.name.empty() && level.name.find_first_of(" \t") == std::string::npos;
  if (!is_word || level.output < 0 || level.output > 9999 || !std::isfinite(level.per) || level.per == 0.0)
    return refuse();
  return level;
}

}  // namespace

const char* toString(RobotLanguage language) { return nameOf(language).name; }
const char* suffixOf(RobotLanguage language) { return nameOf(language).suffix; }

std::optional<RobotLanguage> robotLanguageOf(const std::string& path) {
  const std::string suffix = smallSuffix(path);
  for (const LanguageName& each : kLanguages)
    if (suffix == each.suffix) return each.language;
  return std::nullopt;
}

void describe(SettingsSchema& schema, RobotProgramSettings& settings) {
  schema.text("robot_program.name", settings.name,
              "Name of a robot's program; empty for that of the file. Further files are numbered.");
  schema.integer("robot_program.tool_number", settings.tool_number, {0, 32},
                 "Number of the tool on the controller.");
  schema.number(
      "robot_program.tool_mass_kg", settings.tool_mass_kg, {0.0, 1000.0},
      "Mass that the flange carries, as written in KRL and URScript; 0 for that of the controller.");
  schema.numbers("robot_program.tool_centre_of_gravity_mm", settings.tool_centre_of_gravity_mm, 3,
                 "Centre of gravity of what the flange carries, over the flange; empty for that of the "
                 "controller.");
  schema.integer("robot_program.frame_number", settings.frame_number, {0, 64},
                 "Number of the frame on the controller that is the bed.");
  schema.number("robot_program.approach_mm", settings.approach_mm, {0.0, 1000.0},
                "How far back along the tool axis a program starts by a move of the joints, and ends.");
  schema.number("robot_program.corner_mm", settings.corner_mm, {0.0, 100.0},
                "By how much points between may be rounded.");
  schema.number("robot_program.joint_speed_percent", settings.joint_speed_percent, {1.0, 100.0},
                "Speed of the move of the joints, of the fastest.");
  schema.integer(
      "robot_program.dry_flag", settings.dry_flag, {0, 99},
      "Number of the variable on the controller that switches the process off for a dry run: $FLAG[n] "
      "in KRL, R[n], B of INFORM; a script has lamina_dry, whatever the number. 0 for none.");
  schema.number("robot_program.dry_speed_percent", settings.dry_speed_percent, {1.0, 100.0},
                "Speed of a dry run by robot_program.dry_flag, of the program's speeds, in KRL and URScript; "
                "100 for these.");
  schema.integer("robot_program.process_output", settings.process_output, {0, 4096},
                 "Digital output that is on while material is deposited.");
  schema.number("robot_program.process_lead_s", settings.process_lead_s, {0.0, 600.0},
                "Wait from the process on to the move.");
  schema.number("robot_program.process_end_s", settings.process_end_s, {0.0, 600.0},
                "Wait from the process off to the next move.");
  describeArc(schema, settings.arc);
  schema.text("robot_program.levels", settings.levels,
              "Analogue outputs of process values, with commas between: name=output*per, where the output is "
              "set to the value times per; 0 while the process is off.");
  schema.numbers(
      "robot_program.joint_signs", settings.joint_signs, 6,
      "1 or -1 for each joint: which way the controller counts it, over the description; empty for "
      "the same way.");
  schema.numbers("robot_program.joint_zeros_deg", settings.joint_zeros_deg, 6,
                 "Where the controller counts each joint that the description has at zero; empty for zero.");
  schema.text("robot_program.external_axes", settings.external_axes,
              "Axes of the controller by external joint, with commas between, with a minus where they count "
              "the other way and the value at the joint's zero behind: external_1=e2, external_2=-e1+90. "
              "Empty for e1, e2, ... in the order of the joints.");
  schema.flag(
      "robot_program.allow_cut", settings.may_cut,
      "Whether a run that no file can hold is cut, with the process stopped there; else it is refused.");
  schema.text("robot_program.date", settings.date,
              "Date that files state, as 2000-01-31: they are the same every time.");
  describeKrl(schema, settings.krl);
  describeUrScript(schema, settings.urscript);
  describeFanuc(schema, settings.fanuc);
  describeInform(schema, settings.inform);
}

std::vector<RobotLevel> robotLevels(const std::string& text) {
  std::vector<RobotLevel> levels;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    RobotLevel level = levelOf(trimmed(rest.substr(0, comma)));
    for (const RobotLevel& other : levels)
      if (other.name == level.name || other.output == level.output)
        throw InvalidConfig("robot_program.levels names '" + level.name + "' at output " +
                            std::to_string(level.output) + " after '" + other.name + "' at output " +
                            std::to_string(other.output) + "; must differ");
    levels.push_back(std::move(level));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return levels;
}

void requireConsistent(const RobotProgramSettings& settings) {
  if ((settings.tool_mass_kg > 0.0) != (settings.tool_centre_of_gravity_mm.size() == 3))
    throw InvalidConfig(
        "robot_program.tool_mass_kg is " + numberText(settings.tool_mass_kg) + " kg with " +
        std::to_string(settings.tool_centre_of_gravity_mm.size()) +
        " numbers in robot_program.tool_centre_of_gravity_mm; expected a mass above 0 with the 3 of "
        "its centre, or neither");
  for (const double sign : settings.joint_signs)
    if (std::abs(sign) != 1.0)
      throw InvalidConfig("robot_program.joint_signs holds " + numberText(sign) + "; must be 1 or -1");
  for (const double axis : settings.fanuc.turn_axes)
    if (axis != std::round(axis) || axis < 1.0 || axis > 6.0)
      throw InvalidConfig("fanuc.turn_axes holds " + numberText(axis) + "; must be joints 1 to 6");
  requirePulses("inform.pulses_per_deg", settings.inform.pulses_per_deg,
                "the pulses in a degree of each joint");
  requirePulses("inform.external_pulses", settings.inform.external_pulses,
                "the pulses in a mm or a degree of each external axis");
  if (settings.arc.weave_schedule > 0 && settings.arc.process == RobotProcess::Outputs)
    throw InvalidConfig("robot_program.weave_schedule is " + std::to_string(settings.arc.weave_schedule) +
                        " with robot_program.process 'outputs'; expected 0, or 'schedules'");
  if (settings.dry_flag > 0 && settings.arc.process == RobotProcess::Schedules)
    throw InvalidConfig(
        "robot_program.dry_flag is " + std::to_string(settings.dry_flag) +
        " with robot_program.process 'schedules'; expected 0: the controller's arc package has "
        "a switch of its own that blocks the process, or 'outputs'");
  if (settings.dry_speed_percent < 100.0 && settings.dry_flag == 0)
    throw InvalidConfig("robot_program.dry_speed_percent is " + numberText(settings.dry_speed_percent) +
                        " with robot_program.dry_flag 0; expected 100, or the number of a variable");
  if (settings.fanuc.weld_speed == FanucWeldSpeed::Schedule && settings.arc.process == RobotProcess::Outputs)
    throw InvalidConfig(
        "fanuc.weld_speed is 'schedule' with robot_program.process 'outputs'; expected 'stated', or "
        "'schedules'");
  requireDate(settings.date);
  robotLevels(settings.levels);
  robotExternals(settings.external_axes);
}

}  // namespace lamina
