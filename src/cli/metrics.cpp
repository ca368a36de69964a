// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/toolpath_metrics.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/part/part_in_program.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/timing.hpp"
#include "output/metrics_table.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina metrics` as it was typed.
struct MetricsArguments {
  std::vector<std::string> inputs;
  std::string part;
  std::string output;
  std::vector<double> offset;
  bool simulates = false;
  SettingOptions settings;
};

/// One program against the part.
struct MeasuredProgram {
  std::string name;
  std::string placing;  ///< how it was found where the part is
  Point3 program_from_part = Point3::Zero();
  double part_volume_mm3 = 0.0;  ///< of the part as it is printed, before it shrinks
  double part_area_mm2 = 0.0;
  double estimated_time_s = 0.0;
  ToolpathMetrics metrics;
};

MeasuredProgram measureInput(const std::string& input, const ComparedPart& drawn,
                             const MetricsArguments& arguments, const JobSettings& asked) {
  const JobSettings settings =
      withStatedShrinkage(asked, input, overridesFrom(arguments.settings.assignments));
  const ComparedPart part = asPrinted(drawn, settings);
  MeasuredProgram measured;
  measured.name = std::filesystem::path(input).filename().string();
  measured.part_volume_mm3 = std::abs(volume(part.mesh));
  measured.part_area_mm2 = surfaceArea(part.mesh);
  ToolpathInput read = readToolpath(input, settings);
  TerminalProgress progress;
  if (isPart(input)) {
    measured.placing = "sliced";
    measured.program_from_part = read.bed_from_part.translation();
  } else {
    std::optional<Point3> given;
    if (!arguments.offset.empty()) given = Point3(arguments.offset.data());
    const PartInProgram found = findPart(read.toolpath, part, given, settings, progress);
    measured.placing = toString(found.finding);
    measured.program_from_part = found.program_from_part;
    read.bed_from_part.translation() = found.program_from_part;
    read.toolpath = placed(read.toolpath, read.bed_from_part.inverse());
  }
  measured.estimated_time_s = estimateTime(read.toolpath, settings.motion).total_s;
  measured.metrics =
      measureToolpath(read.toolpath, part.mesh, read.bed_from_part, settings.metrics, progress);
  return measured;
}

nlohmann::ordered_json metricOrNull(double value) {
  return std::isnan(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
}

nlohmann::ordered_json toJson(const MeasuredProgram& program) {
  const Point3& place = program.program_from_part;
  nlohmann::ordered_json json = {{"name", program.name},
                                 {"placing", program.placing},
                                 {"program_from_part_mm", {place.x(), place.y(), place.z()}},
                                 {"part_volume_mm3", program.part_volume_mm3},
                                 {"part_area_mm2", program.part_area_mm2},
                                 {"estimated_time_s", program.estimated_time_s}};
  const std::vector<double> values = metricValues(program.metrics);
  const std::vector<std::string> names = metricNames();
  for (std::size_t m = 0; m < values.size(); ++m) json["metrics"][names[m]] = metricOrNull(values[m]);
  return json;
}

NumberTable tableOf(const std::vector<MeasuredProgram>& programs) {
  NumberTable table;
  table.rows = metricNames();
  for (const MeasuredProgram& program : programs) {
    table.columns.push_back(program.name);
    table.values.push_back(metricValues(program.metrics));
  }
  return table;
}

void printJson(const std::vector<MeasuredProgram>& programs, const ComparedPart& part) {
  nlohmann::ordered_json json = {{"part", part.name},
                                 {"volume_mm3", std::abs(volume(part.mesh))},
                                 {"area_mm2", surfaceArea(part.mesh)},
                                 {"programs", nlohmann::json::array()}};
  for (const MeasuredProgram& program : programs) json["programs"].push_back(toJson(program));
  std::printf("%s\n", json.dump(2).c_str());
}

/// Where a program's part is, and its size where that differs from the part as drawn.
void printPart(const MeasuredProgram& program, double drawn_mm3) {
  const Point3& place = program.program_from_part;
  std::printf("%s: part at %.3f, %.3f, %.3f mm (%s)", program.name.c_str(), place.x(), place.y(), place.z(),
              program.placing.c_str());
  if (program.part_volume_mm3 != drawn_mm3)
    std::printf(", printed as %.6g mm3, %.6g mm2 before it shrinks", program.part_volume_mm3,
                program.part_area_mm2);
  std::printf("\n");
}

void printText(const std::vector<MeasuredProgram>& programs, const ComparedPart& part) {
  const double drawn_mm3 = std::abs(volume(part.mesh));
  std::printf("part %s, %.6g mm3, %.6g mm2\n", part.name.c_str(), drawn_mm3, surfaceArea(part.mesh));
  for (const MeasuredProgram& program : programs) printPart(program, drawn_mm3);
  std::printf("%s", toText(tableOf(programs)).c_str());
}

void requireFiles(const MetricsArguments& arguments) {
  requireSuffix(arguments.output, {".csv", ".md"});
  std::vector<std::string> inputs = arguments.inputs;
  inputs.insert(inputs.end(), {arguments.part, arguments.settings.config});
  requireApart({arguments.output}, inputs);
}

void metrics(const MetricsArguments& arguments, OutputFormat format) {
  requireFiles(arguments);
  JobSettings settings = jobSettingsFrom(arguments.settings);
  validate(settings);
  if (arguments.simulates) settings.metrics.simulates_platform = true;
  const ComparedPart part = readComparedPart(arguments.part, settings.input);
  std::vector<MeasuredProgram> programs;
  for (const std::string& input : arguments.inputs)
    programs.push_back(measureInput(input, part, arguments, settings));
  if (!arguments.output.empty()) writeTable(tableOf(programs), arguments.output);
  format == OutputFormat::Json ? printJson(programs, part) : printText(programs, part);
}

}  // namespace

void addMetrics(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "metrics", "Measure time, material, travel, fill of the surface and volume error of programs");
  const auto arguments = std::make_shared<MetricsArguments>();
  subcommand
      ->add_option("input", arguments->inputs,
                   "Programs (.gcode, .mod), toolpaths (.csv), or the part itself, to be sliced")
      ->required();
  subcommand->add_option("--part", arguments->part, "Mesh file or name of the part that they make")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Table to write (.csv, .md)");
  subcommand
      ->add_option("--offset", arguments->offset,
                   "Where the part's origin is in the programs, x,y,z in mm; without it, it is found")
      ->delimiter(',')
      ->expected(3);
  subcommand->add_flag("--simulate", arguments->simulates,
                       "Simulate the six-legged platform for energy and tracking errors");
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for metrics, reading and slicing");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { metrics(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
