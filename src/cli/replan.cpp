// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr double kClearance = 5.0;       // mm above the part, before anything else moves
constexpr double kSameDirection = 1e-6;  // of unit vectors

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

[[noreturn]] void refuseCell(const CsvTable& table, std::size_t row, const std::string& column,
                             const std::string& expected) {
  throw InvalidInput(table.source + ", line " + std::to_string(table.lines[row]) + ": " + column + " is " +
                     table.rows[row][columnOf(table, column)] + "; expected " + expected);
}

std::size_t layerAt(const CsvTable& table, std::size_t row) {
  const double layer = numberAt(table, row, "layer");
  if (layer < 0.0 || layer > kMostLayers || layer != std::floor(layer))
    refuseCell(table, row, "layer", "a whole number from 0");
  return static_cast<std::size_t>(layer);
}

/// The highest layer of `loop_layers.csv` that was seen, by its last row.
MeasuredLayer lastMeasured(const CsvTable& table) {
  std::optional<std::size_t> last;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (numberAt(table, row, "coverage") > 0.0 && (!last || layerAt(table, row) >= layerAt(table, *last)))
      last = row;
  if (!last) throw InvalidInput(table.source + ": no layer was seen; expected one with a coverage above 0");
  const double most = LayerWindow().greatest_flow;
  const double gain = numberAt(table, *last, "gain_mean");
  if (!(gain >= 1.0 / most && gain <= most))
    refuseCell(table, *last, "gain_mean", "a gain that 0.4 to 2.5 times the volume makes up for");
  return {layerAt(table, *last), numberAt(table, *last, "mean_error_mm"), gain};
}

/// @throws InvalidInput if a part would end below the bed that it stands on
void requireAboveBed(const Toolpath& toolpath, const MeasuredLayer& measured) {
  if (measured.layer >= toolpath.layers.size()) return;  // refused as no layer that is left
  const double planned_mm = toolpath.layers[measured.layer].z_mm;
  if (planned_mm - measured.mean_error_mm > 0.0) return;
  throw InvalidInput("layer " + std::to_string(measured.layer) + " ends at " + numberText(planned_mm) +
                     " mm, and its mean error is " + numberText(measured.mean_error_mm) +
                     " mm: it would have ended below the bed; expected a smaller error");
}

/// Lines of a start code that heat, in their order.
std::string heatingOf(const std::string& start_code) {
  std::string heating;
  std::istringstream lines(start_code);
  for (std::string line; std::getline(lines, line);) {
    const std::string_view word = trimmed(line).substr(0, 4);
    if (word == "M104" || word == "M109" || word == "M140" || word == "M190" || word == "M141" ||
        word == "M191")
      heating += '\n' + line;
  }
  return heating;
}

/// Settings of a program that begins over a part: it neither homes nor wipes, and rises above the part before
/// it heats. Only level layers say how far that is.
ProgramSettings overThePart(ProgramSettings settings, const Toolpath& toolpath,
                            const MeasuredLayer& measured) {
  const std::string heating = heatingOf(settings.start_code);
  settings.start_code = "G21\nG90";
  const double top_mm = toolpath.layers[measured.layer].z_mm + std::max(0.0, -measured.mean_error_mm);
  if ((layerNormal(toolpath) - Point3::UnitZ()).norm() < kSameDirection) {
    std::array<char, 48> rise{};
    std::snprintf(rise.data(), rise.size(), "\nG0 Z%.3f F600", top_mm + kClearance);
    settings.start_code += rise.data();
  }
  settings.start_code += heating;
  return settings;
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
  if (isGcodeFile(arguments.output))
    std::printf(
        "start     no homing, the heating of program.start_code alone; the machine must know its position, "
        "and the "
        "nozzle stand above all that is deposited\n");
}

void replan(const ReplanArguments& arguments, OutputFormat format) {
  const JobSettings settings = jobSettingsFrom(arguments.settings);
  if (arguments.output.empty()) throw InvalidConfig("no output named; expected -o FILE.gcode or FILE.csv");
  requireSuffix(arguments.output, outputSuffixes());
  requireApart({arguments.output}, {arguments.toolpath, arguments.figures, arguments.settings.config});
  const ToolpathInput input = readToolpath(arguments.toolpath, settings);
  const MeasuredLayer measured = lastMeasured(readCsvTable(arguments.figures));
  requireAboveBed(input.toolpath, measured);
  const LayersLeft left{measured.layer + 1, measured.mean_error_mm};
  const Replanning by = arguments.by == "add" ? Replanning::Add : Replanning::Scale;
  const auto heights = newHeights(partUnderWay(input.toolpath, left, measured.gain_mean), by);
  if (!heights)
    throw InvalidInput("no number of layers of 0.7 to 1.3 of their heights makes up for " +
                       numberText(measured.mean_error_mm) + " mm above layer " +
                       std::to_string(measured.layer) + "; expected more layers left, or a smaller error");
  const PlacedToolpath planned{replannedToolpath(input.toolpath, left, *heights), {}};
  const std::string id = replannedId(planned.toolpath, left.first, toolpathId(input.toolpath));
  writeOutput(arguments.output, planned, overThePart(settings.program, input.toolpath, measured));
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
