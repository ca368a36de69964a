// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/profile_options.hpp"
#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/picture/toolpath_picture.hpp"
#include "output/layer_overlay.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina preview` as it was typed.
struct PreviewArguments {
  std::string input;
  std::string output = "preview.png";
  std::string part;
  ProfileOptions machine;
  SettingOptions settings;
  std::optional<std::size_t> layer;
  std::string view = "oblique";
  std::string colour = "role";
};

void print(const Toolpath& toolpath, const PreviewArguments& arguments, OutputFormat format) {
  const ToolpathTotals sums = totals(toolpath);
  if (format == OutputFormat::Text) {
    std::printf("%zu layers, %zu waypoints; written to %s\n", sums.layers, sums.waypoints,
                arguments.output.c_str());
    return;
  }
  const nlohmann::ordered_json json = {{"layers", sums.layers},
                                       {"waypoints", sums.waypoints},
                                       {"deposition_runs", sums.deposition_runs},
                                       {"deposition_mm", sums.deposition_mm},
                                       {"travel_mm", sums.travel_mm},
                                       {"deposited_mm3", sums.deposited_mm3},
                                       {"output", arguments.output}};
  std::printf("%s\n", json.dump(2).c_str());
}

/// Without a machine nothing follows from one.
JobSettings jobOf(const PreviewArguments& arguments) {
  return arguments.machine.machine.empty()
             ? jobSettingsFrom(arguments.settings)
             : layeredSettingsFrom(arguments.machine, arguments.settings).settings;
}

/// What one layer leaves of the part; the others need not be looked at.
LayerOverlay overlayFor(const Toolpath& toolpath, const PreviewArguments& arguments,
                        const JobSettings& settings) {
  if (arguments.part.empty()) return {};
  VoidJob job;
  job.part = arguments.part;
  job.settings =
      withStatedShrinkage(settings, arguments.input, overridesFrom(arguments.settings.assignments));
  TerminalProgress progress;
  VoidReport report;
  report.part = placeContours(toolpath, job, progress);
  const std::size_t layer = *arguments.layer;
  report.layers.resize(toolpath.layers.size());
  if (layer < report.layers.size())
    report.layers[layer] = findVoids(report.part.contours[layer], toolpath.layers[layer], job.map);
  return layer < report.layers.size() ? overlayOf(report, layer) : LayerOverlay{};
}

void preview(const PreviewArguments& arguments, OutputFormat format) {
  if (arguments.output.empty()) throw InvalidInput("output has no name; expected a picture to write (.png)");
  requireSuffix(arguments.output, {".png"});
  requireApart({arguments.output}, {arguments.input, arguments.part, arguments.settings.config});
  if (!arguments.part.empty() && !arguments.layer)
    throw InvalidInput("--part is '" + arguments.part + "' without --layer; voids are drawn in one layer");
  const JobSettings job = jobOf(arguments);
  const Toolpath toolpath = readToolpath(arguments.input, job).toolpath;
  ToolpathPictureSettings settings;
  settings.view = arguments.view == "top" ? PictureView::Top : PictureView::Oblique;
  settings.colour = arguments.colour == "height" ? PictureColour::Height : PictureColour::Role;
  if (arguments.layer)
    drawToolpathLayer(toolpath, *arguments.layer, overlayFor(toolpath, arguments, job), settings,
                      arguments.output);
  else
    drawToolpath(toolpath, settings, arguments.output);
  print(toolpath, arguments, format);
}

}  // namespace

void addPreview(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("preview", "Draw a program, a toolpath or a sliced part");
  const auto arguments = std::make_shared<PreviewArguments>();
  subcommand
      ->add_option(
          "input", arguments->input,
          "Program (.gcode, .mod, .src, .script, .ls, .jbi), toolpath (.csv), mesh file or name of a part")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Picture to write (.png)")->capture_default_str();
  subcommand->add_option("--layer", arguments->layer, "Draw this layer from above; the first is 0")
      ->check(CLI::Range(0, kMostLayers));
  subcommand->add_option("--part", arguments->part,
                         "Draw what the layer leaves open or overfills of this mesh file or named part");
  subcommand->add_option("--view", arguments->view, "Where the part is seen from")
      ->check(CLI::IsMember({"oblique", "top"}))
      ->capture_default_str();
  subcommand->add_option("--colour", arguments->colour, "What the colours report")
      ->check(CLI::IsMember({"role", "height"}))
      ->capture_default_str();
  addMachineOption(*subcommand, arguments->machine);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing and reading");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { preview(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
