// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/incline_arguments.hpp"

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina::cli {
namespace {

/// An option that stands for a setting.
struct Shorthand {
  const char* option;
  const char* key;
};

struct OptionGroup {
  const char* name;
  std::vector<Shorthand> options;
};

std::vector<OptionGroup> optionGroups() {
  return {{"Map",
           {{"--map", "incline.map"},
            {"--angle-deg", "incline.angle_deg"},
            {"--axis", "incline.axis"},
            {"--shear", "incline.shear"},
            {"--factors", "incline.factors"},
            {"--matrix", "incline.matrix"},
            {"--belt-deg", "incline.belt_deg"}}},
          {"Place",
           {{"--table-position", "incline.table_position_mm"},
            {"--offset", "incline.offset_mm"},
            {"--layer-height", "incline.layer_height_mm"},
            {"--lift", "incline.lift"},
            {"--machine", "machine.name"},
            {"--tool-axis,--jet", "incline.tool_axis"},
            {"--limits", "incline.limits_mm"}}},
          {"Code",
           {{"--final-position", "incline.final_position_mm"},
            {"--final-feed", "incline.final_feed_mm_min"},
            {"--decimals", "incline.decimals"},
            {"--chord-tolerance", "incline.chord_tolerance_mm"}}},
          {"Reading",
           {{"--mode", "incline.mode"},
            {"--homing", "incline.homing"},
            {"--build-aids", "incline.build_aids"},
            {"--extrusion-rule", "incline.extrusion_rule"},
            {"--extrusion", "incline.extrusion"}}}};
}

const Setting& settingOf(const SettingsSchema& schema, const std::string& key) {
  for (const Setting& setting : schema.settings())
    if (setting.key == key) return setting;
  throw Error(ErrorCode::Internal, "no setting '" + key + "'");
}

std::string helpOf(const Setting& setting) {
  const std::string usual = setting.get();
  return setting.meaning + " (" + setting.type + (setting.bounds.empty() ? "" : " in " + setting.bounds) +
         (usual.empty() ? "" : "; " + usual) + ")";
}

void addShorthands(CLI::App& subcommand, InclineArguments& arguments) {
  InclineSettings usual;
  SettingsSchema schema;
  describe(schema, usual);
  for (const OptionGroup& group : optionGroups())
    for (const Shorthand& shorthand : group.options) {
      const std::string key = shorthand.key;
      const auto take = [&arguments, key](const std::string& text) {
        arguments.options.push_back({key, text});
      };
      subcommand.add_option_function<std::string>(shorthand.option, take, helpOf(settingOf(schema, key)))
          ->group(group.name);
    }
}

}  // namespace

void addOptions(CLI::App& subcommand, InclineArguments& arguments) {
  subcommand.add_option("program", arguments.program, "Program (.gcode)");
  subcommand.add_option("-o,--output", arguments.output,
                        "Program to write (.gcode); <program>_rotate.gcode beside the program if not given");
  addShorthands(subcommand, arguments);
  subcommand.add_option("--begin-code", arguments.begin_code, "File to put after the comments at the head")
      ->group("Code");
  subcommand.add_option("--end-code", arguments.end_code, "File to put at the end")->group("Code");
  addSettingOptions(subcommand, arguments.settings, "Settings (YAML); those not given keep their defaults");
  subcommand.add_flag("--print-config", arguments.prints_config,
                      "Print the default settings as YAML and stop");
}

InclineJob jobFrom(const InclineArguments& arguments) {
  if (arguments.program.empty()) throw InvalidInput("no program is given; expected a .gcode file");
  std::vector<SettingText> overrides = arguments.options;
  if (!arguments.begin_code.empty())
    overrides.push_back({"incline.begin_code", readTextFile(arguments.begin_code)});
  if (!arguments.end_code.empty())
    overrides.push_back({"incline.end_code", readTextFile(arguments.end_code)});
  for (SettingText& setting : overridesFrom(arguments.settings.assignments))
    overrides.push_back(std::move(setting));
  return inclineJob(loadInclineSettings(arguments.settings.config, overrides), arguments.program,
                    arguments.output);
}

}  // namespace lamina::cli
