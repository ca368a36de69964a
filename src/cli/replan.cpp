// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina replan` as it was typed.
struct ReplanArguments {
  std::string toolpath;
  std::string figures;
  std::string output;
  std::string by = "scale";
  SettingOptions settings;
};

/// What the loop found of the layer that it measured last.
struct MeasuredLayer {
  std::size_t layer = 0;
  double mean_error_mm = 0.0;
  double gain_mean = 1.0;
};

double numberAt(const CsvTable& table, std::size_t row, const std::string& column) {
  const std::string& cell = table.rows[row][columnOf(table, column)];
  double number = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (cell.empty() || result.ec != std::errc{} || result.ptr != cell.data() + cell.size() ||
      !std::isfinite(number))
    throw InvalidInput(table.source + ", line " + std::to_string(table.lines[row]) + ": " + column +
                       " is no number");
  return number;
}

/// The last row of `loop_layers.csv` whose layer was seen.
MeasuredLayer lastMeasured(const CsvTable& table) {
  for (std::size_t row = table.rows.size(); row-- > 0;) {
    if (!(numberAt(table, row, "coverage") > 0.0)) continue;
    const double layer = numberAt(table, row, "layer");
    if (layer < 0.0 || layer > kMostLayers || layer != std::floor(layer))
      throw InvalidInput(table.source + ", line " + std::to_string(table.lines[row]) + ": layer is " +
                         std::to_string(layer) + "; expected a whole number from 0");
    const double gain = numberAt(table, row, "gain_mean");
    if (!(gain > 0.0))
      throw InvalidInput(table.source + ", line " + std::to_string(table.lines[row]) + ": gain_mean is " +
                         std::to_string(gain) + "; expected a positive gain");
    return {static_cast<std::size_t>(layer), numberAt(table, row, "mean_error_mm"), gain};
  }
  throw InvalidInput(table.source + ": no layer was seen; expected one with a coverage above 0");
}

void print(const ReplanArguments& arguments, const PlacedToolpath& planned, const std::string& id,
           const NewHeights& heights, OutputFormat format) {
  const double top_mm = planned.toolpath.layers.back().z_mm;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {
        {"output", arguments.output},       {"toolpath_id", id},    {"layers", heights.heights_mm.size()},
        {"heights_mm", heights.heights_mm}, {"flow", heights.flow}, {"top_mm", top_mm}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s: %zu layers of %.4g to %.4g mm, up to %.4g mm, %.4g times the volume; toolpath %s\n",
              arguments.output.c_str(), heights.heights_mm.size(), heights.heights_mm.front(),
              heights.heights_mm.back(), top_mm, heights.flow, id.c_str());
}

void replan(const ReplanArguments& arguments, OutputFormat format) {
  const JobSettings settings = jobSettingsFrom(arguments.settings);
  if (arguments.output.empty()) throw InvalidConfig("no output named; expected -o FILE.gcode or FILE.csv");
  requireSuffix(arguments.output, outputSuffixes());
  requireApart({arguments.output}, {arguments.toolpath, arguments.figures, arguments.settings.config});
  const ToolpathInput input = readToolpath(arguments.toolpath, settings);
  const MeasuredLayer measured = lastMeasured(readCsvTable(arguments.figures));
  const LayersLeft left{measured.layer + 1, measured.mean_error_mm};
  const Replanning by = arguments.by == "add" ? Replanning::Add : Replanning::Scale;
  const auto heights = newHeights(partUnderWay(input.toolpath, left, measured.gain_mean), by);
  if (!heights)
    throw InvalidInput("no number of layers of 0.7 to 1.3 of their heights makes up for " +
                       std::to_string(measured.mean_error_mm) + " mm above layer " +
                       std::to_string(measured.layer) + "; expected more layers left, or a smaller error");
  const PlacedToolpath planned{replannedToolpath(input.toolpath, left, *heights), {}};
  const std::string id = replannedId(planned.toolpath, left.first, toolpathId(input.toolpath));
  writeOutput(arguments.output, planned, settings.program);
  print(arguments, planned, id, *heights, format);
}

}  // namespace

void addReplan(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "replan", "Plan the layers left anew, so that a part that grew otherwise than planned ends at its top");
  const auto arguments = std::make_shared<ReplanArguments>();
  subcommand->add_option("toolpath", arguments->toolpath, "Toolpath (.csv) or program (.gcode, .mod)")
      ->required();
  subcommand
      ->add_option("figures", arguments->figures,
                   "Figures of its layers (loop_layers.csv): the last one seen counts")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Layers left (.gcode, .csv, .mod)");
  subcommand
      ->add_option("--by", arguments->by,
                   "scale: heights of 0.7 to 1.3 of those planned; add: more or fewer layers as planned")
      ->check(CLI::IsMember({"scale", "add"}))
      ->capture_default_str();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for reading and writing");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { replan(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
