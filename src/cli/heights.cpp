// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "arguments/setting_options.hpp"
#include "lamina/job/layer_heights_job.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina heights` as it was typed.
struct HeightsArguments {
  std::string part;
  std::string output;
  SettingOptions settings;
};

bool isLower(const LayerBounds& a, const LayerBounds& b) { return a.height() < b.height(); }

void printJson(const LayerHeightsReport& report, const std::string& output) {
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (const LayerBounds& layer : report.bounds)
    layers.push_back({{"bottom_mm", layer.bottom_mm}, {"top_mm", layer.top_mm}});
  nlohmann::ordered_json missed = nlohmann::ordered_json::array();
  for (const MissedFlat& flat : report.missed)
    missed.push_back({{"z_mm", flat.z_mm}, {"off_mm", flat.off_mm}});
  const nlohmann::ordered_json json = {{"layers", layers},
                                       {"greatest_cusp_mm", report.greatest_cusp_mm},
                                       {"missed_flats", missed},
                                       {"output", output}};
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const LayerHeightsReport& report, const std::string& output) {
  std::printf("layers      %zu", report.bounds.size());
  if (!report.bounds.empty()) {
    const auto [least, greatest] = std::minmax_element(report.bounds.begin(), report.bounds.end(), isLower);
    std::printf(", %.4g to %.4g mm high", least->height(), greatest->height());
  }
  std::printf("\ncusp        %.4g mm at most, above the first layer\n", report.greatest_cusp_mm);
  for (const MissedFlat& flat : report.missed)
    std::printf("missed      level face at %.6g mm, %.3g mm from the end of a layer\n", flat.z_mm,
                flat.off_mm);
  if (!output.empty()) std::printf("written to  %s\n", output.c_str());
}

void heights(const HeightsArguments& arguments, OutputFormat format) {
  const LayerHeightsReport report =
      runLayerHeightsJob({arguments.part, arguments.output, jobSettingsFrom(arguments.settings)});
  format == OutputFormat::Json ? printJson(report, arguments.output) : printText(report, arguments.output);
}

}  // namespace

void addHeights(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("heights", "How high the layers of a part are, as a table");
  const auto arguments = std::make_shared<HeightsArguments>();
  subcommand->add_option("part", arguments->part, "Mesh file or name of a parametric part")->required();
  subcommand->add_option("-o,--output", arguments->output,
                         "Table to write (CSV), which slicing.heights_file reads");
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML); slicing.heights chooses the heights");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { heights(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
