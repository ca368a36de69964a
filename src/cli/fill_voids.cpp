// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "fill_drop_voids.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/job/voids/void_filling.hpp"
#include "lamina/program/drops/drop_program.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina fill-voids` as it was typed.
struct FillVoidsArguments {
  std::string program;
  std::string part;
  std::string output;
  SettingOptions settings;
  std::vector<double> offset;
  RefillSettings refill;
  DropFillArguments drops;
  std::vector<std::string> for_beads;  ///< options given that programs of drops do not follow
  std::vector<std::string> for_drops;  ///< options given that programs of beads do not follow
};

/// Those of the options that stand on the command line.
std::vector<std::string> givenOf(const CLI::App& subcommand, const std::vector<std::string>& options) {
  std::vector<std::string> given;
  for (const std::string& option : options)
    if (subcommand.count(option) > 0) given.push_back(option);
  return given;
}

void requireNone(const std::vector<std::string>& given, const std::string& program, const std::string& lays) {
  if (given.empty()) return;
  throw InvalidInput("'" + program + "' lays " + lays + "; expected none of the options " + listed(given) +
                     ", which do not apply to such a program");
}

JobSettings settingsFrom(const FillVoidsArguments& arguments) {
  std::vector<SettingText> overrides = overridesOf(arguments.drops);
  for (SettingText& setting : overridesFrom(arguments.settings.assignments))
    overrides.push_back(std::move(setting));
  return withStatedShrinkage(loadJobSettings(arguments.settings.config, overrides), arguments.program,
                             overrides);
}

VoidFillingJob jobFrom(const FillVoidsArguments& arguments) {
  if (arguments.part.empty())
    throw InvalidInput("no part is given; voids between beads are those of a part (--part)");
  VoidFillingJob job;
  job.program = arguments.program;
  job.output = arguments.output;
  job.map.part = arguments.part;
  job.map.settings = settingsFrom(arguments);
  if (!arguments.offset.empty()) job.map.offset = Point2(arguments.offset[0], arguments.offset[1]);
  job.refill = arguments.refill;
  return job;
}

nlohmann::ordered_json toJson(const VoidTotals& sums) {
  return {{"voids", sums.voids},
          {"uncovered_percent_mean", sums.uncovered.mean_percent},
          {"uncovered_percent_worst", sums.uncovered.worst_percent},
          {"overfill_percent_mean", sums.overfill.mean_percent},
          {"overfill_percent_worst", sums.overfill.worst_percent},
          {"material_percent", sums.material_percent},
          {"runs_per_layer_mean", sums.runs_per_layer_mean}};
}

void printJson(const VoidFillingReport& report, const FillVoidsArguments& arguments) {
  const nlohmann::ordered_json json = {
      {"layers", report.before.layers},   {"layers_filled", report.layers},
      {"runs_added", report.runs},        {"deposited_mm3", report.deposited_mm3},
      {"left_open_mm3", report.open_mm3}, {"before", toJson(report.before)},
      {"after", toJson(report.after)},    {"output", arguments.output}};
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const VoidFillingReport& report, const FillVoidsArguments& arguments) {
  std::printf("added       %zu runs in %zu of %zu layers, %.2f mm3\n", report.runs, report.layers,
              report.before.layers, report.deposited_mm3);
  if (report.open_mm3 > 0.0) std::printf("left open   %.2f mm3 of sparse infill\n", report.open_mm3);
  std::printf("voids       %zu before, %zu after\n", report.before.voids, report.after.voids);
  std::printf("uncovered   %.3f %% before, %.3f %% after\n", report.before.uncovered.mean_percent,
              report.after.uncovered.mean_percent);
  std::printf("overfill    %.3f %% before, %.3f %% after\n", report.before.overfill.mean_percent,
              report.after.overfill.mean_percent);
  std::printf("written to  %s\n", arguments.output.c_str());
}

void fillVoids(const FillVoidsArguments& arguments, OutputFormat format) {
  if (arguments.output.empty() && arguments.drops.sweep.empty())
    throw InvalidInput("no output is given; expected a program to write (-o), or a table (--sweep)");
  requireSuffix(arguments.output, {".gcode"});
  requireSuffix(arguments.drops.sweep, {".csv"});
  requireApart({arguments.output, arguments.drops.sweep},
               {arguments.program, arguments.part, arguments.settings.config});
  const JobSettings settings = settingsFrom(arguments);
  if (isDropProgram(readTextFile(arguments.program), settings.program.drops)) {
    requireNone(arguments.for_beads, arguments.program, "drops");
    return fillDropVoids({arguments.program, arguments.output, arguments.drops.sweep}, settings, format);
  }
  requireNone(arguments.for_drops, arguments.program, "beads");
  VoidFillingReport report;
  {
    TerminalProgress progress;
    report = runVoidFillingJob(jobFrom(arguments), progress);
  }
  format == OutputFormat::Json ? printJson(report, arguments) : printText(report, arguments);
}

}  // namespace

void addFillVoids(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("fill-voids", "Add runs, or drops, to a program where it leaves voids in its part");
  const auto arguments = std::make_shared<FillVoidsArguments>();
  subcommand->add_option("program", arguments->program, "Program (.gcode)")->required();
  subcommand->add_option("-o,--output", arguments->output,
                         "Program to write (.gcode); needed unless --sweep is given");
  subcommand->add_option(
      "--part", arguments->part,
      "Mesh file or name of a parametric part; needed for a program of beads, and for that only");
  subcommand
      ->add_option("--least-area", arguments->refill.least_area,
                   "Smaller voids stay, in squared widths of a bead")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  subcommand
      ->add_option("--least-width", arguments->refill.least_width,
                   "Narrower places stay, in widths of a bead")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  subcommand
      ->add_option("--offset", arguments->offset,
                   "Where the part's origin is in the program, x,y in mm; found if not given")
      ->delimiter(',')
      ->expected(2);
  addTo(*subcommand, arguments->drops);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading and for the new runs");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, subcommand, &chosen] {
    arguments->for_beads = givenOf(*subcommand, {"--part", "--offset", "--least-area", "--least-width"});
    arguments->for_drops =
        givenOf(*subcommand, {"--overlap", "--definition", "--detector", "--iterate", "--sweep"});
    chosen.run = [arguments, &chosen] { fillVoids(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
