// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/scaffold/scaffold.hpp"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina scaffold` as it was typed.
struct ScaffoldArguments {
  std::string kind;
  std::string output;
  std::string dialect;
  SettingOptions settings;
  bool lists = false;
  bool prints_config = false;
};

/// What a scaffold is made by and how it is written.
struct ScaffoldJob {
  ScaffoldSettings scaffold;
  ProgramSettings program;
};

void describe(SettingsSchema& schema, ScaffoldJob& job) {
  lamina::describe(schema, job.scaffold);
  lamina::describe(schema, job.program);
}

void listKinds(OutputFormat format) {
  nlohmann::ordered_json kinds;
  for (const std::string& name : scaffoldNames()) {
    if (format == OutputFormat::Text)
      std::printf("%-18s%s\n", name.c_str(), scaffoldMeaning(name).c_str());
    else
      kinds[name] = scaffoldMeaning(name);
  }
  if (format == OutputFormat::Json) std::printf("%s\n", kinds.dump(2).c_str());
}

/// The dialect of G-code that the command line names; "lamina" is Marlin's, which has Lamina's comments.
/// @throws InvalidConfig if there is none
std::string dialectOf(const std::string& named) {
  std::string dialect = named == "lamina" ? "marlin" : named;
  gcodeDialects().find(dialect);
  return dialect;
}

void print(const ScaffoldArguments& arguments, const Toolpath& toolpath, OutputFormat format) {
  const ToolpathTotals sums = totals(toolpath);
  const Point3 size = depositionBox(toolpath).size();
  const double top = toolpath.layers.back().z_mm;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"scaffold", arguments.kind},
                                         {"output", arguments.output},
                                         {"layers", sums.layers},
                                         {"deposition_runs", sums.deposition_runs},
                                         {"deposition_mm", sums.deposition_mm},
                                         {"travel_mm", sums.travel_mm},
                                         {"deposited_mm3", sums.deposited_mm3},
                                         {"height_mm", top},
                                         {"centre_lines_mm", {size.x(), size.y()}}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s: %s, %zu layers to %.4g mm, %zu runs, %.2f m, %.2f mm3\n", arguments.output.c_str(),
              arguments.kind.c_str(), sums.layers, top, sums.deposition_runs, sums.deposition_mm / 1e3,
              sums.deposited_mm3);
}

void scaffold(const ScaffoldArguments& arguments, OutputFormat format) {
  if (arguments.lists) return listKinds(format);
  if (arguments.kind.empty()) throw InvalidConfig("no scaffold named; 'lamina scaffold --list' names them");
  ScaffoldJob job{scaffoldDefaults(arguments.kind), {}};
  job.program.dialect = "fullcontrol";
  SettingsSchema schema;
  describe(schema, job);
  applySettings(schema, arguments.settings.config, overridesFrom(arguments.settings.assignments));
  if (!arguments.dialect.empty()) job.program.dialect = dialectOf(arguments.dialect);
  if (arguments.prints_config) return printConfig(schema, format);
  if (arguments.output.empty()) throw InvalidConfig("no output named; expected -o FILE.gcode or FILE.csv");
  requireSuffix(arguments.output, outputSuffixes());
  requireApart({arguments.output}, {arguments.settings.config});
  const Toolpath toolpath = makeScaffold(arguments.kind, job.scaffold);
  writeOutput(arguments.output, {toolpath, {}}, job.program);
  print(arguments, toolpath, format);
}

}  // namespace

void addScaffold(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("scaffold", "Write a parametric scaffold or specimen as a toolpath or program");
  const auto arguments = std::make_shared<ScaffoldArguments>();
  subcommand->add_option("kind", arguments->kind, "What to make; --list names the kinds");
  subcommand->add_option("-o,--output", arguments->output, "File to write (.gcode, .csv, .mod)");
  subcommand->add_option("--dialect", arguments->dialect,
                         "Of G-code, as program.dialect: fullcontrol, the default, or lamina");
  subcommand->add_flag("--list", arguments->lists, "List the kinds instead");
  subcommand->add_flag("--print-config", arguments->prints_config, "Print the settings of the kind instead");
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) of scaffold and program");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { scaffold(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
