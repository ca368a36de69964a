// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/rapid_settings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

const std::vector<std::pair<std::string, RapidVariant>>& variants() {
  static const std::vector<std::pair<std::string, RapidVariant>> all = {
      {"powder_3_axes", RapidVariant::Powder3Axes},
      {"powder_5_axes", RapidVariant::Powder5Axes},
      {"wire_3_axes", RapidVariant::Wire3Axes}};
  return all;
}

void describeNames(SettingsSchema& schema, RapidSettings& settings) {
  schema.text("rapid.module", settings.module,
              "Name of the module; empty for that of the file. Parts of a split one are numbered.");
  schema.text("rapid.procedure", settings.procedure, "Begins the names of the procedures that deposit.");
  schema.text("rapid.tool", settings.tool,
              "Name of the tool; empty for t_cursoDic with powder, t_COAXwire with wire.");
  schema.text("rapid.work_object", settings.work_object,
              "Name of the work object; empty for temple with powder, w_frametrabajo with wire.");
  schema.text("rapid.start_point", settings.start_point, "Target that points of 3 axes are offsets from.");
  schema.text("rapid.offset", settings.offset, "Begins the names of the offsets in x, y and z.");
  schema.text("rapid.deposition_speed", settings.deposition_speed,
              "Name of the speed of deposition; further feeds are numbered.");
  schema.text("rapid.air_speed", settings.air_speed, "Name of the speed of air moves.");
  schema.text("rapid.zone", settings.zone, "Zone of points between.");
  schema.text("rapid.end_zone", settings.end_zone, "Zone of points where the process starts or ends.");
  schema.text("rapid.laser_on", settings.laser_on, "Procedure that starts the laser (powder).");
  schema.text("rapid.laser_off", settings.laser_off, "Procedure that stops the laser (powder).");
  schema.text("rapid.laser_signal", settings.laser_signal, "Output that asks for the laser.");
  schema.text("rapid.laser_ready_signal", settings.laser_ready_signal,
              "Input that reports that the laser is ready (wire).");
  schema.text("rapid.wire_signal", settings.wire_signal, "Output that feeds the wire.");
  schema.text("rapid.powder_signal", settings.powder_signal, "Output that feeds the powder.");
  schema.text("rapid.gas_signal", settings.gas_signal, "Output that opens the gas (powder).");
  schema.text("rapid.wire_trigger", settings.wire_trigger,
              "Trigger that stops the wire before the end of a run.");
  schema.text("rapid.aliases", settings.aliases,
              "Signals that have other names on the controller: name=name of the controller, with commas "
              "between.");
}

void describeArc(SettingsSchema& schema, RapidSettings& settings) {
  schema.choice<RapidProcess>("rapid.process", settings.process,
                              {{"outputs", RapidProcess::Outputs}, {"arc", RapidProcess::Arc}},
                              "Whether the process is switched by outputs, or by moves of the arc package: "
                              "ArcLStart, ArcL, ArcLEnd.");
  schema.text(
      "rapid.levels", settings.levels,
      "Analogue outputs of process values, with commas between: value=signal*per, where the output is "
      "set to the value times per; 0 while the process is off.");
  schema.flag(
      "rapid.dry_flag", settings.has_dry_flag,
      "Whether the module declares lamina_dry, a PERS bool: TRUE runs the program without its process.");
  schema.number("rapid.dry_speed_percent", settings.dry_speed_percent, {1.0, 100.0},
                "Speed of a dry run by rapid.dry_flag, of the program's speeds; 100 for these.");
  schema.text("rapid.seam_data", settings.seam_data,
              "Name of the seam data of arc moves, on the controller.");
  schema.text("rapid.weld_data", settings.weld_data,
              "Name of the weld data of arc moves, on the controller.");
  schema.text("rapid.weave_data", settings.weave_data,
              "Name of the weave data of arc moves, on the controller; empty for none.");
}

void describeCell(SettingsSchema& schema, RapidSettings& settings) {
  schema.flag("rapid.declare_cell", settings.declares_cell,
              "Whether the module declares tool, work object and start point; else the controller has them.");
  schema.numbers("rapid.tool_frame", settings.tool_frame, 7,
                 "Tip of the tool over the flange [mm], and its orientation w x y z; empty for that of the "
                 "arm's description.");
  schema.numbers("rapid.tool_centre_of_gravity_mm", settings.tool_centre_of_gravity_mm, 3,
                 "Centre of gravity of the tool over the flange.");
  schema.number("rapid.tool_mass_kg", settings.tool_mass_kg, {0.0, 1000.0},
                "Mass of the tool; 0 for that of robot_program.tool_mass_kg or of the cell file, with its "
                "centre.");
  schema.numbers("rapid.work_object_frame", settings.work_object_frame, 7,
                 "The bed over the robot's world, or over the user frame of its positioner [mm], and its "
                 "orientation w x y z; empty for that of the arm's description.");
  schema.text("rapid.positioner", settings.positioner,
              "Mechanical unit that carries the bed; empty if the bed stands still, or for STN1 where an "
              "external axis of the arm's description carries it.");
  schema.number("rapid.approach_mm", settings.approach_mm, {0.0, 1000.0},
                "How far back along the tool axis an arm's program starts by MoveAbsJ and ends.");
  schema.numbers("rapid.start_point_mm", settings.start_point_mm, 3,
                 "Start point in the work object as it is declared; the part lies where it was planned until "
                 "the point is taught anew.");
  schema.choice<RapidConfiguration>(
      "rapid.configuration", settings.configuration,
      {{"fixed", RapidConfiguration::Fixed}, {"joints", RapidConfiguration::Joints}},
      "Configuration of the arm: the same in all targets, or that of the joints at each.");
  schema.numbers("rapid.fixed_configuration", settings.fixed_configuration, 4,
                 "Configuration cf1, cf4, cf6, cfx where it is the same in all targets.");
  schema.number(
      "rapid.external_axis", settings.external_axis, {-1e5, 1e5},
      "Value of the first external axis [mm, deg] where no joint of the machine gives it; 0: an arm "
      "of the description has none there.");
  schema.text(
      "rapid.external_axes", settings.external_axes,
      "Logical axes of the controller that external joints are, with commas between: joint=axis, with "
      "- before the axis where it counts the other way, and its value where the joint is at zero behind: "
      "external_1=eax_b, external_2=-eax_c+90; empty: eax_a, eax_b, ... in the order of the joints.");
  schema.flag("rapid.thesis_compat", settings.is_thesis_compatible,
              "Five external axes in targets, as printed in [Flores2018]; RAPID has six.");
}

void describeValues(SettingsSchema& schema, RapidSettings& settings) {
  schema.number("rapid.zone_mm", settings.zone_mm, Bounds::above(0.0, 200.0),
                "Radius of rapid.zone where that is a name which RAPID does not know.");
  schema.number("rapid.turn_speed_deg_s", settings.turn_speed_deg_s, Bounds::above(0.0, 1000.0),
                "Speed at which the tool turns, in each speed that is declared.");
  schema.number("rapid.powder_wait_s", settings.powder_wait_s, {0.0, 600.0},
                "Wait from powder and gas on to the first move.");
  schema.number("rapid.laser_off_wait_s", settings.laser_off_wait_s, {0.0, 600.0},
                "Wait after the laser is off (powder).");
  schema.number("rapid.wire_lead_s", settings.wire_lead_s, {0.0, 600.0},
                "Wait from wire on to laser on: waiting1.");
  schema.number("rapid.laser_lead_s", settings.laser_lead_s, {0.0, 600.0},
                "Wait from laser on to the move: waiting2.");
  schema.number("rapid.layer_wait_s", settings.layer_wait_s, {0.0, 600.0},
                "Wait after the laser is off (wire): t_capas.");
  schema.number("rapid.wire_stop_s", settings.wire_stop_s, {0.0, 10.0},
                "How long before the end of a run the wire stops.");
  schema.integer("rapid.max_points", settings.max_points, {0, 1e7},
                 "Points in a module at most; 0 for all in one.");
  schema.choice<RapidLoading>(
      "rapid.loading", settings.loading,
      {{"together", RapidLoading::Together}, {"in_turn", RapidLoading::InTurn}},
      "Modules of a split program are all loaded beforehand, or each when its turn comes.");
}

void requireNumbers(const std::string& key, const std::vector<double>& numbers, std::size_t count) {
  if (numbers.size() != count)
    throw InvalidConfig(key + " has " + std::to_string(numbers.size()) + " numbers; must be " +
                        std::to_string(count));
}

void requireRotation(const std::string& key, const std::vector<double>& frame) {
  requireNumbers(key, frame, 7);
  const double square = frame[3] * frame[3] + frame[4] * frame[4] + frame[5] * frame[5] + frame[6] * frame[6];
  constexpr double kUnit = 1e-4;  // RAPID refuses what is farther off
  if (!(std::abs(square - 1.0) < kUnit))
    throw InvalidConfig(key + " has an orientation of length " + numberText(std::sqrt(square)) +
                        "; must be 1");
}

void requireListed(const RapidSettings& settings) {
  requireRotation("rapid.tool_frame", settings.tool_frame);
  requireRotation("rapid.work_object_frame", settings.work_object_frame);
  requireNumbers("rapid.tool_centre_of_gravity_mm", settings.tool_centre_of_gravity_mm, 3);
  requireNumbers("rapid.start_point_mm", settings.start_point_mm, 3);
  requireNumbers("rapid.fixed_configuration", settings.fixed_configuration, 4);
  for (const double value : settings.fixed_configuration)
    if (value != std::round(value) || std::abs(value) > 100.0)
      throw InvalidConfig("rapid.fixed_configuration holds " + numberText(value) +
                          "; must be whole numbers of quarter turns");
}

/// Each name of the program and the key it comes from.
std::vector<std::pair<std::string, std::string>> namesOf(const RapidSettings& settings) {
  return {{"rapid.module", settings.module},
          {"rapid.procedure", settings.procedure},
          {"the approach, after rapid.procedure,", settings.procedure + "_start"},
          {"the retract, after rapid.procedure,", settings.procedure + "_end"},
          {"rapid.tool", settings.tool},
          {"rapid.work_object", settings.work_object},
          {"rapid.start_point", settings.start_point},
          {"rapid.offset", settings.offset},
          {"rapid.deposition_speed", settings.deposition_speed},
          {"rapid.zone", settings.zone},
          {"rapid.laser_on", settings.laser_on},
          {"rapid.laser_off", settings.laser_off},
          {"rapid.laser_signal", settings.laser_signal},
          {"rapid.laser_ready_signal", settings.laser_ready_signal},
          {"rapid.wire_signal", settings.wire_signal},
          {"rapid.powder_signal", settings.powder_signal},
          {"rapid.gas_signal", settings.gas_signal},
          {"rapid.wire_trigger", settings.wire_trigger},
          {"the flag", std::string(kRapidDryFlag)},
          {"the wait", "waiting1"},
          {"the wait", "waiting2"},
          {"the wait", "t_capas"}};
}

void requireNames(const RapidSettings& settings) {
  std::map<std::string, std::string> taken = {{"main", "the procedure that is run"}};
  for (const auto& [key, name] : namesOf(settings)) {
    requireRapidName(key, name);
    const auto [earlier, is_new] = taken.emplace(lowerCase(name), key);
    if (!is_new) throw InvalidConfig(key + " is '" + name + "', as is " + earlier->second + "; must differ");
  }
  // Both speeds may be one of RAPID's own, as in the listing of 5 axes.
  requireRapidName("rapid.air_speed", settings.air_speed);
  const auto earlier = taken.find(lowerCase(settings.air_speed));
  const bool is_speed = lowerCase(settings.air_speed) == lowerCase(settings.deposition_speed) &&
                        rapidSpeed(settings.air_speed).has_value();
  if (earlier != taken.end() && !is_speed)
    throw InvalidConfig("rapid.air_speed is '" + settings.air_speed + "', as is " + earlier->second +
                        "; must differ");
  if (!settings.positioner.empty()) requireRapidName("rapid.positioner", settings.positioner);
  if (settings.end_zone != "fine" && !isRapidZone(settings.end_zone))
    throw InvalidConfig("rapid.end_zone is '" + settings.end_zone +
                        "'; must be fine or a zone of RAPID's own");
}

void requireDryRun(const RapidSettings& settings) {
  if (settings.dry_speed_percent < 100.0 && !settings.has_dry_flag)
    throw InvalidConfig("rapid.dry_speed_percent is " + numberText(settings.dry_speed_percent) +
                        " with rapid.dry_flag false; expected 100, or true");
}

void requireArc(const RapidSettings& settings) {
  if (settings.process == RapidProcess::Outputs) {
    if (!settings.weave_data.empty())
      throw InvalidConfig("rapid.weave_data is '" + settings.weave_data +
                          "' with rapid.process 'outputs'; expected none, or 'arc'");
    return;
  }
  if (settings.has_dry_flag)
    throw InvalidConfig(
        "rapid.dry_flag is true with rapid.process 'arc'; expected false: the arc package has a switch of "
        "its own "
        "that blocks the process, or 'outputs'");
  if (settings.variant == RapidVariant::Wire3Axes)
    throw InvalidConfig(
        "rapid.process is 'arc' with rapid.variant 'wire_3_axes', which feeds its wire by outputs; expected "
        "'powder_5_axes' or 'powder_3_axes', whose moves arc statements take");
  requireRapidName("rapid.seam_data", settings.seam_data);
  requireRapidName("rapid.weld_data", settings.weld_data);
  if (!settings.weave_data.empty()) requireRapidName("rapid.weave_data", settings.weave_data);
}

void requireLevels(const RapidSettings& settings) {
  const std::vector<RapidLevel> levels = rapidLevels(settings.levels);
  if (levels.empty()) return;
  if (settings.process == RapidProcess::Arc)
    throw InvalidConfig(
        "rapid.levels is '" + settings.levels +
        "' with rapid.process 'arc'; expected none: values of arcs are those of their weld data");
  for (const RapidLevel& level : levels)
    for (const auto& [key, name] : namesOf(settings))
      if (lowerCase(name) == lowerCase(level.signal))
        throw InvalidConfig("rapid.levels names '" + level.signal + "', as does " + key + "; must differ");
}

void requireExternals(const RapidSettings& settings) {
  const std::vector<RapidExternal> externals = rapidExternals(settings.external_axes);
  if (externals.empty()) return;
  if (settings.external_axis != 0.0)
    throw InvalidConfig("rapid.external_axis is " + numberText(settings.external_axis) +
                        " with rapid.external_axes '" + settings.external_axes +
                        "', which gives axes by joints; expected 0");
  for (const RapidExternal& external : externals)
    if (settings.is_thesis_compatible && external.slot >= kThesisAxes)
      throw InvalidConfig("rapid.external_axes names eax_f with rapid.thesis_compat, which has " +
                          std::to_string(kThesisAxes) + " axes; expected eax_a to eax_e");
}

void requireAliases(const RapidSettings& settings) {
  const std::vector<std::string> signals = {settings.laser_signal, settings.laser_ready_signal,
                                            settings.wire_signal, settings.powder_signal,
                                            settings.gas_signal};
  for (const RapidAlias& alias : rapidAliases(settings.aliases)) {
    if (std::find(signals.begin(), signals.end(), alias.signal) == signals.end())
      throw InvalidConfig("rapid.aliases names '" + alias.signal + "'; must be one of " + listed(signals));
    requireRapidName("rapid.aliases", alias.on_controller);
  }
}

}  // namespace

const char* toString(RapidVariant variant) {
  for (const auto& [name, value] : variants())
    if (value == variant) return name.c_str();
  return "";
}

void describe(SettingsSchema& schema, RapidSettings& settings) {
  schema.choice<RapidVariant>("rapid.variant", settings.variant, variants(),
                              "What is deposited by how many axes.");
  describeNames(schema, settings);
  describeCell(schema, settings);
  describeArc(schema, settings);
  describeValues(schema, settings);
}

RapidSettings checkedRapidSettings(RapidSettings settings) {
  const bool is_wire = settings.variant == RapidVariant::Wire3Axes;
  if (settings.module.empty()) settings.module = "Lamina";
  if (settings.tool.empty()) settings.tool = is_wire ? "t_COAXwire" : "t_cursoDic";
  const std::vector<double> none = {0, 0, 0, 1, 0, 0, 0};
  if (settings.tool_frame.empty()) settings.tool_frame = none;
  if (settings.work_object_frame.empty()) settings.work_object_frame = none;
  if (settings.work_object.empty()) settings.work_object = is_wire ? "w_frametrabajo" : "temple";
  settings.is_load_given = settings.tool_mass_kg > 0.0;
  if (!settings.is_load_given) settings.tool_mass_kg = 1.0;
  requireListed(settings);
  requireDryRun(settings);
  requireArc(settings);
  requireNames(settings);
  requireLevels(settings);
  requireExternals(settings);
  requireAliases(settings);
  return settings;
}

std::vector<RapidAlias> rapidAliases(const std::string& text) {
  std::vector<RapidAlias> aliases;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view entry = rest.substr(0, comma);
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos)
      throw InvalidConfig("rapid.aliases holds '" + std::string(trimmed(entry)) +
                          "'; must be name=name of the controller");
    aliases.push_back(
        {std::string(trimmed(entry.substr(0, equals))), std::string(trimmed(entry.substr(equals + 1)))});
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return aliases;
}

}  // namespace lamina
