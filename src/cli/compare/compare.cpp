// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "arguments/setting_options.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/modes/mode_comparison.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/picture/mode_picture.hpp"
#include "output/figure.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina compare` as it was typed.
struct CompareArguments {
  std::string part;
  std::string output;
  std::vector<std::string> modes;
  SettingOptions settings;
};

std::vector<std::string> figuresOf(const ModeCandidate& candidate) {
  const std::string steps =
      candidate.steps == 1 ? " along one direction" : " in " + std::to_string(candidate.steps) + " steps";
  return {figure("%.2f %% of the surface unsupported", candidate.unsupported_percent),
          std::to_string(candidate.layers) + " layers" + steps,
          figure("%.1f min of printing", candidate.time_s / 60.0)};
}

void draw(const ModeComparison& comparison, const SliceJob& job) {
  ModePicture picture{std::filesystem::path(job.part).stem().string() + " on " + job.settings.machine.name,
                      "from above and from below; red: surface that overhangs its own layers by more than " +
                          figure("%.4g deg", job.settings.automatic.max_overhang_deg) +
                          "\na step is a piece printed along one direction, or a bent layer",
                      comparison.part,
                      {}};
  for (std::size_t i = 0; i < comparison.modes.size(); ++i) {
    const ComparedMode& mode = comparison.modes[i];
    const std::string remark = comparison.chosen == i ? "what auto takes" : "";
    const bool is_refused = !mode.candidate.refusal.empty();
    picture.panels.push_back({mode.candidate.mode, remark, mode.candidate.refusal,
                              is_refused ? std::vector<std::string>{} : figuresOf(mode.candidate),
                              mode.toolpath, mode.unsupported});
  }
  drawModes(picture, job.output);
}

void printText(const ModeComparison& comparison) {
  std::printf("%-16s %12s %7s %7s %9s\n", "mode", "unsupported", "steps", "layers", "time min");
  for (std::size_t i = 0; i < comparison.modes.size(); ++i) {
    const ModeCandidate& mode = comparison.modes[i].candidate;
    if (!mode.refusal.empty())
      std::printf("%-16s refused: %s\n", mode.mode.c_str(), mode.refusal.c_str());
    else
      std::printf("%-16s %10.2f %% %7zu %7zu %9.1f%s\n", mode.mode.c_str(), mode.unsupported_percent,
                  mode.steps, mode.layers, mode.time_s / 60.0,
                  comparison.chosen == i ? "  what auto takes" : "");
  }
}

void printJson(const ModeComparison& comparison, const std::string& output) {
  nlohmann::ordered_json json;
  for (const ComparedMode& compared : comparison.modes) {
    const ModeCandidate& mode = compared.candidate;
    if (!mode.refusal.empty())
      json["modes"].push_back({{"mode", mode.mode}, {"refusal", mode.refusal}});
    else
      json["modes"].push_back({{"mode", mode.mode},
                               {"unsupported_percent", mode.unsupported_percent},
                               {"steps", mode.steps},
                               {"layers", mode.layers},
                               {"time_s", mode.time_s}});
  }
  json["auto"] = comparison.chosen
                     ? nlohmann::ordered_json(comparison.modes[*comparison.chosen].candidate.mode)
                     : nlohmann::ordered_json();
  json["output"] = output;
  std::printf("%s\n", json.dump(2).c_str());
}

void compare(const CompareArguments& arguments, OutputFormat format) {
  if (!arguments.output.empty()) requireSuffix(arguments.output, {".png"});
  requireApart({arguments.output}, {arguments.part, arguments.settings.config});
  const JobSettings settings = jobSettingsFrom(arguments.settings);
  // Poses, which any head that tilts may run; the picture is no program.
  const SliceJob poses{arguments.part, "", settings};
  TerminalProgress progress;
  const ModeComparison comparison =
      compareModes(poses, arguments.modes.empty() ? comparableModes(poses) : arguments.modes, progress);
  if (!arguments.output.empty()) draw(comparison, {arguments.part, arguments.output, settings});
  if (format == OutputFormat::Json) return printJson(comparison, arguments.output);
  printText(comparison);
  if (!arguments.output.empty()) std::printf("drawn in %s\n", arguments.output.c_str());
}

}  // namespace

void addCompare(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("compare", "Slice a part by several modes, and draw their layers side by side");
  const auto arguments = std::make_shared<CompareArguments>();
  subcommand
      ->add_option("part", arguments->part,
                   "Mesh file (STL, OBJ, PLY, 3MF, STEP) or name of a parametric part")
      ->required();
  subcommand->add_option("-o,--output", arguments->output, "Picture to write (.png)");
  subcommand
      ->add_option("--modes", arguments->modes,
                   "Slicing modes, separated by commas; those that suit the machine if left out")
      ->delimiter(',');
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { compare(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
