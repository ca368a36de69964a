// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/setting_options.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/voids/void_job.hpp"
#include "lamina/job/voids/void_report_csv.hpp"
#include "lamina/picture/toolpath_picture.hpp"
#include "lamina/voids/beads/void_totals.hpp"
#include "output/layer_overlay.hpp"
#include "output/terminal_progress.hpp"
#include "output/void_json.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina voids` as it was typed.
struct VoidArguments {
  std::string program;
  std::string part;
  std::string output;
  std::string picture;
  SettingOptions settings;
  std::vector<double> offset;
  std::optional<std::size_t> layer;
};

VoidJob jobFrom(const VoidArguments& arguments) {
  VoidJob job;
  job.part = arguments.part;
  job.settings = withStatedShrinkage(jobSettingsFrom(arguments.settings), arguments.program,
                                     overridesFrom(arguments.settings.assignments));
  if (!arguments.offset.empty()) job.offset = Point2(arguments.offset[0], arguments.offset[1]);
  return job;
}

nlohmann::ordered_json classCounts(const std::vector<LayerVoids>& layers) {
  nlohmann::ordered_json counts = nlohmann::json::object();
  for (const VoidClass kind : kVoidClasses) counts[toString(kind)] = 0;
  for (const LayerVoids& layer : layers)
    for (const Void& each : layer.voids)
      counts[toString(each.kind)] = counts[toString(each.kind)].get<int>() + 1;
  return counts;
}

/// Missing layers are counted behind those of the program, and have no number of it.
bool isMissing(std::size_t layer, const VoidReport& report) {
  return layer >= report.layers.size() && layer - report.layers.size() < report.part.missing.size();
}

void addShare(nlohmann::ordered_json& json, const std::string& name, const AreaShare& share,
              const VoidReport& report) {
  json[name + "_percent_mean"] = share.mean_percent;
  json[name + "_percent_total"] = share.total_percent;
  json[name + "_percent_worst"] = share.worst_percent;
  json[name + "_worst_layer"] = share.worst_layer;
  if (isMissing(share.worst_layer, report)) json[name + "_worst_layer"] = nullptr;
}

std::string placeOf(std::size_t layer, const VoidReport& report) {
  if (!isMissing(layer, report)) return "layer " + std::to_string(layer);
  char text[64];
  std::snprintf(text, sizeof text, "the missing layer at z %.3f mm",
                report.part.missing[layer - report.layers.size()].z_mm);
  return text;
}

void printShare(const char* name, const AreaShare& share, const VoidReport& report) {
  std::printf("%-11s %.3f %% of a layer in the mean, %.3f %% of all, at worst %.3f %% in %s\n", name,
              share.mean_percent, share.total_percent, share.worst_percent,
              placeOf(share.worst_layer, report).c_str());
}

void printJson(const VoidReport& report, const VoidArguments& arguments) {
  const VoidTotals sums = totals(report);
  nlohmann::ordered_json json = {{"layers", sums.layers}, {"layers_missing", report.part.missing.size()}};
  addShare(json, "uncovered", sums.uncovered, report);
  addShare(json, "overfill", sums.overfill, report);
  json.update({{"material_percent", sums.material_percent},
               {"runs_per_layer_mean", sums.runs_per_layer_mean},
               {"voids", sums.voids},
               {"voids_by_class", classCounts(report.layers)},
               {"offset_mm", {report.part.offset.x(), report.part.offset.y()}}});
  if (!report.part.other_section.empty()) json["other_section"] = report.part.other_section;
  if (arguments.layer) json["layer"] = layerToJson(report.layers[*arguments.layer], *arguments.layer);
  if (!arguments.output.empty()) json["output"] = arguments.output;
  if (!arguments.picture.empty()) json["picture"] = arguments.picture;
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const VoidReport& report, const VoidArguments& arguments) {
  const VoidTotals sums = totals(report);
  std::printf("layers      %zu, %.1f runs each\n", sums.layers, sums.runs_per_layer_mean);
  if (!report.part.missing.empty())
    std::printf("missing     %zu layers of the part, counted as uncovered\n", report.part.missing.size());
  if (!report.part.other_section.empty()) std::printf("note        %s\n", report.part.other_section.c_str());
  printShare("uncovered", sums.uncovered, report);
  printShare("overfill", sums.overfill, report);
  std::printf("material    %.2f %% of what fills the layers\n", sums.material_percent);
  std::printf("voids       %zu\n", sums.voids);
  if (arguments.part.empty()) return;
  std::printf("part at     %.3f, %.3f mm from its own origin\n", report.part.offset.x(),
              report.part.offset.y());
}

void requireLayer(const VoidArguments& arguments, std::size_t layers) {
  if (arguments.layer && *arguments.layer >= layers)
    throw InvalidInput("layer " + std::to_string(*arguments.layer) + " does not exist; '" +
                       arguments.program + "' has " + std::to_string(layers) + " layers, the first is 0");
}

void requireVoidOutputs(const VoidArguments& arguments) {
  requireSuffix(arguments.output, {".csv", ".json"});
  requireSuffix(arguments.picture, {".png"});
  requireApart({arguments.output, arguments.picture},
               {arguments.program, arguments.part, arguments.settings.config});
}

void write(const std::vector<LayerVoids>& layers, const std::string& output) {
  const std::string suffix = std::filesystem::path(output).extension().string();
  if (suffix == ".csv") writeVoidCsv(output, layers);
  if (suffix == ".json") writeVoidJson(output, layers);
}

void findVoidsOf(const VoidArguments& arguments, OutputFormat format) {
  requireVoidOutputs(arguments);
  const VoidJob job = jobFrom(arguments);
  const Toolpath program = readProgram(arguments.program, job.settings.program, job.settings.machine);
  requireLayer(arguments, program.layers.size());
  VoidReport report;
  {
    TerminalProgress progress;
    report = runVoidJob(program, job, progress);
  }
  write(report.layers, arguments.output);
  if (!arguments.picture.empty()) {
    const std::size_t drawn = arguments.layer.value_or(totals(report.layers).uncovered.worst_layer);
    drawToolpathLayer(program, drawn, overlayOf(report, drawn), {}, arguments.picture);
  }
  format == OutputFormat::Json ? printJson(report, arguments) : printText(report, arguments);
}

}  // namespace

void addVoids(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("voids", "Compare what a program deposits with the part it should fill");
  const auto arguments = std::make_shared<VoidArguments>();
  subcommand->add_option("program", arguments->program, "Program (.gcode, .mod)")->required();
  subcommand->add_option("--part", arguments->part,
                         "Mesh file or name of a parametric part; without it, what the outer walls enclose");
  subcommand->add_option("--layer", arguments->layer, "Report the voids of this layer; the first is 0")
      ->check(CLI::Range(0, kMostLayers));
  subcommand->add_option("-o,--output", arguments->output,
                         "File to write: a table with one line per layer (.csv), or all voids (.json)");
  subcommand->add_option("--picture", arguments->picture,
                         "Picture to write (.png) of that layer, or of the worst");
  subcommand
      ->add_option("--offset", arguments->offset,
                   "Where the part's origin is in the program, x,y in mm; found if not given")
      ->delimiter(',')
      ->expected(2);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { findVoidsOf(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
