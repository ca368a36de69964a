// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang.hpp"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/picture/overhang_picture.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "output/figure.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina overhang` as it was typed.
struct OverhangArguments {
  std::string input;
  std::string before;
  std::string picture;
  SettingOptions settings;
  std::size_t worst = 5;
};

/// One side of the comparison.
struct Account {
  double inclination_deg = 0.0;
  OverhangReport report;
  OverhangTotals sums;
};

Account accountOf(const ToolpathInput& input, const JobSettings& settings) {
  Account account;
  account.inclination_deg = inclinationDeg(input.toolpath);
  TerminalProgress progress;
  account.report = findOverhangs(input.toolpath, input.bed_from_part, settings.overhang, progress);
  account.sums = totals(account.report);
  return account;
}

/// What the input is compared with: another file, or the part in level layers where it is inclined.
std::optional<ToolpathInput> inputBefore(const OverhangArguments& arguments, const JobSettings& settings) {
  if (!arguments.before.empty()) {
    JobSettings level = settings;
    level.slicing.plane = {};
    return readToolpath(arguments.before, level);
  }
  if (!isPart(arguments.input) || settings.slicing.plane.angle_deg == 0.0) return std::nullopt;
  TerminalProgress progress;
  SlicedPart sliced = runLevelSliceJob({arguments.input, "", settings}, progress);
  return ToolpathInput{std::move(sliced.toolpath), sliced.bed_from_part};
}

nlohmann::ordered_json toJson(const UnsupportedStretch& stretch) {
  const Point3& from = stretch.points.front();
  const Point3& to = stretch.points.back();
  return {{"kind", toString(stretch.kind)},   {"length_mm", stretch.length_mm},
          {"layer", stretch.at.layer},        {"path", stretch.at.path},
          {"role", toString(stretch.role)},   {"waypoint", stretch.at.waypoint},
          {"begins_run", stretch.begins_run}, {"from_mm", {from.x(), from.y(), from.z()}},
          {"to_mm", {to.x(), to.y(), to.z()}}};
}

nlohmann::ordered_json toJson(const Account& account, std::size_t worst) {
  const OverhangTotals& sums = account.sums;
  nlohmann::ordered_json json = {{"inclination_deg", account.inclination_deg},
                                 {"deposition_mm", sums.all.deposited_mm},
                                 {"unsupported_mm", sums.all.unsupported()},
                                 {"unsupported_share", sums.share()},
                                 {"unsupported_in_walls_mm", sums.in_walls_mm},
                                 {"overhang_mm", sums.all.overhang_mm},
                                 {"overhangs", sums.overhangs},
                                 {"longest_overhang_mm", sums.longest_overhang_mm},
                                 {"bridge_mm", sums.all.bridge_mm},
                                 {"bridges", sums.bridges},
                                 {"longest_bridge_mm", sums.longest_bridge_mm},
                                 {"runs", account.report.runs},
                                 {"starts_in_air", sums.all.starts_in_air}};
  json["worst_layer"] = nullptr;
  if (sums.worst_layer) json["worst_layer"] = *sums.worst_layer;
  nlohmann::ordered_json layers = nlohmann::json::array();
  for (const LayerOverhang& layer : account.report.layers) layers.push_back(layer.unsupported());
  json["unsupported_mm_by_layer"] = layers;
  nlohmann::ordered_json stretches = nlohmann::json::array();
  for (const StretchKind kind : {StretchKind::Overhang, StretchKind::Bridge})
    for (const UnsupportedStretch& stretch : longest(account.report, kind, worst))
      stretches.push_back(toJson(stretch));
  json["worst"] = stretches;
  return json;
}

void printJson(const Account& account, const std::optional<Account>& before, std::size_t worst) {
  nlohmann::ordered_json json = toJson(account, worst);
  if (before) json["before"] = toJson(*before, worst);
  std::printf("%s\n", json.dump(2).c_str());
}

/// A line with a figure, or two of them if there is something to compare with.
class Table {
 public:
  Table(const Account& account, const std::optional<Account>& before) : account_(account), before_(before) {}

  template <class Cell>
  void row(const char* name, const Cell& cell) const {
    std::printf("%-16s", name);
    if (before_) std::printf("%24s", cell(*before_).c_str());
    std::printf("%24s\n", cell(account_).c_str());
  }

 private:
  const Account& account_;
  const std::optional<Account>& before_;
};

void printStretch(const UnsupportedStretch& stretch) {
  const Point3& from = stretch.points.front();
  std::printf("%-9s %9.2f mm, layer %zu, path %zu, waypoint %zu, from (%.2f, %.2f, %.2f)%s\n",
              toString(stretch.kind), stretch.length_mm, stretch.at.layer, stretch.at.path,
              stretch.at.waypoint, from.x(), from.y(), from.z(),
              stretch.begins_run ? ", begins in the air" : "");
}

void printText(const Account& account, const std::optional<Account>& before, std::size_t worst) {
  const Table table(account, before);
  if (before) std::printf("%-16s%24s%24s\n", "", "before", "after");
  table.row("layers inclined", [](const Account& a) { return figure("%.4g deg", a.inclination_deg); });
  table.row("deposition", [](const Account& a) { return figure("%.2f m", a.sums.all.deposited_mm / 1e3); });
  table.row("unsupported", [](const Account& a) {
    return figure("%.1f mm", a.sums.all.unsupported()) + figure(", %.2f %%", 100.0 * a.sums.share());
  });
  table.row("  in walls", [](const Account& a) { return figure("%.1f mm", a.sums.in_walls_mm); });
  table.row("overhangs", [](const Account& a) {
    return std::to_string(a.sums.overhangs) + figure(", %.1f mm", a.sums.all.overhang_mm);
  });
  table.row("  longest", [](const Account& a) { return figure("%.2f mm", a.sums.longest_overhang_mm); });
  table.row("bridges", [](const Account& a) {
    return std::to_string(a.sums.bridges) + figure(", %.1f mm", a.sums.all.bridge_mm);
  });
  table.row("  longest", [](const Account& a) { return figure("%.2f mm", a.sums.longest_bridge_mm); });
  table.row("starts in air", [](const Account& a) {
    return std::to_string(a.sums.all.starts_in_air) + " of " + std::to_string(a.report.runs);
  });
  table.row("worst layer", [](const Account& a) {
    if (!a.sums.worst_layer) return std::string("none");
    return std::to_string(*a.sums.worst_layer) +
           figure(", %.1f mm", a.report.layers[*a.sums.worst_layer].unsupported());
  });
  for (const StretchKind kind : {StretchKind::Overhang, StretchKind::Bridge})
    for (const UnsupportedStretch& stretch : longest(account.report, kind, worst)) printStretch(stretch);
}

void overhang(const OverhangArguments& arguments, OutputFormat format) {
  const JobSettings settings = jobSettingsFrom(arguments.settings);
  validate(settings);
  requireSuffix(arguments.picture, {".png"});
  requireApart({arguments.picture}, {arguments.input, arguments.before, arguments.settings.config});
  const ToolpathInput input = readInclinedToolpath(arguments.input, settings);
  const Account account = accountOf(input, settings);
  if (!arguments.picture.empty()) drawOverhangs(input.toolpath, account.report, arguments.picture);
  std::optional<Account> before;
  if (const auto other = inputBefore(arguments, settings)) before = accountOf(*other, settings);
  format == OutputFormat::Json ? printJson(account, before, arguments.worst)
                               : printText(account, before, arguments.worst);
}

}  // namespace

void addOverhang(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("overhang", "Report what is deposited with nothing below it along the tool axis");
  const auto arguments = std::make_shared<OverhangArguments>();
  subcommand
      ->add_option(
          "input", arguments->input,
          "Program (.gcode, .mod), toolpath (.csv), mesh file or name of a part; a part in inclined layers "
          "is compared with the same in level ones")
      ->required();
  subcommand->add_option("--before", arguments->before, "What to compare with: program, toolpath or part");
  subcommand->add_option("--picture", arguments->picture, "Picture to write (.png) of what hangs in the air");
  subcommand
      ->add_option("--worst", arguments->worst, "How many of the longest stretches of a kind are reported")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing and reading");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { overhang(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
