// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fill_drop_voids.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "lamina/base/atomic_file.hpp"
#include "lamina/job/voids/drop_void_sweep.hpp"
#include "output/terminal_progress.hpp"

namespace lamina::cli {
namespace {

nlohmann::ordered_json toJson(const DropVoid& each, std::size_t layer) {
  nlohmann::ordered_json drops = nlohmann::json::array();
  for (const Point2& drop : each.drops) drops.push_back({drop.x(), drop.y()});
  return {{"layer", layer},
          {"class", toString(each.kind)},
          {"points", each.points.size()},
          {"greatest_clearance_mm", each.greatest_clearance_mm},
          {"new_drops", drops},
          {"uncovered_before_mm2", each.uncovered_before_mm2},
          {"uncovered_after_mm2", each.uncovered_after_mm2}};
}

nlohmann::ordered_json toJson(const DropVoidReport& report) {
  const OverlapReading& overlap = report.overlap;
  nlohmann::ordered_json classes = nlohmann::json::object();
  for (const auto& [kind, count] : report.countByClass()) classes[toString(kind)] = count;
  nlohmann::ordered_json voids = nlohmann::json::array();
  for (std::size_t layer = 0; layer < report.voids.size(); ++layer)
    for (const DropVoid& each : report.voids[layer]) voids.push_back(toJson(each, layer));
  return {{"layers", report.voids.size()},
          {"layers_without_contour", report.layers_without_contour},
          {"drops", overlap.prior},
          {"new_drops", overlap.added},
          {"voids", report.count()},
          {"voids_by_class", classes},
          {"greatest_linear_overlap", overlap.greatest_linear},
          {"greatest_area_overlap", overlap.greatest_area},
          {"overlap_per_new_drop", overlap.perNewDrop()},
          {"overlap_per_drop", overlap.perDrop()},
          {"uncovered_before_mm2", report.uncoveredBefore()},
          {"uncovered_after_mm2", report.uncoveredAfter()},
          {"largest_before_mm2", report.largestBefore()},
          {"largest_after_mm2", report.largestAfter()},
          {"worth_it", report.is_worth_it},
          {"void_list", voids}};
}

nlohmann::ordered_json toJson(const DropSweepStep& step) {
  return {{"allowed_overlap", step.overlap},
          {"voids", step.voids},
          {"new_drops", step.reading.added},
          {"greatest_linear_overlap", step.reading.greatest_linear},
          {"greatest_area_overlap", step.reading.greatest_area},
          {"overlap_per_new_drop", step.reading.perNewDrop()},
          {"overlap_per_drop", step.reading.perDrop()},
          {"uncovered_percent_before", uncoveredPercent(step, step.before)},
          {"uncovered_percent_after", uncoveredPercent(step, step.after)},
          {"largest_before_mm2", step.before.largest_mm2},
          {"largest_after_mm2", step.after.largest_mm2},
          {"worth_it", step.is_worth_it}};
}

void printText(const std::vector<DropSweepStep>& steps) {
  std::printf("allowed   voids  new drops  overlap per drop  uncovered inside  largest mm2\n");
  if (!steps.empty())
    std::printf("   none                  0          0.00 %%  %14.2f %%  %11.4f\n",
                uncoveredPercent(steps[0], steps[0].before), steps[0].before.largest_mm2);
  for (const DropSweepStep& step : steps)
    std::printf("%5.0f %%  %6zu  %9zu  %12.2f %%  %14.2f %%  %11.4f%s\n", 100.0 * step.overlap, step.voids,
                step.reading.added, 100.0 * step.reading.perDrop(), uncoveredPercent(step, step.after),
                step.after.largest_mm2, step.is_worth_it ? "" : "  (may not be worth it)");
}

void printText(const DropVoidReport& report) {
  const OverlapReading& overlap = report.overlap;
  std::printf("drops       %zu in %zu layers\n", overlap.prior, report.voids.size());
  std::printf("voids       %zu", report.count());
  for (const auto& [kind, count] : report.countByClass()) std::printf(", %s: %zu", toString(kind), count);
  std::printf("\nnew drops   %zu\n", overlap.added);
  std::printf(
      "overlap     at most %.1f %% of the diameter, %.1f %% of the area; %.2f %% per drop of the part\n",
      100.0 * overlap.greatest_linear, 100.0 * overlap.greatest_area, 100.0 * overlap.perDrop());
  std::printf("uncovered   %.3f -> %.3f mm2 in voids, the largest %.3f -> %.3f mm2\n",
              report.uncoveredBefore(), report.uncoveredAfter(), report.largestBefore(),
              report.largestAfter());
  if (report.layers_without_contour > 0)
    std::printf("left alone  %zu layers without a contour: their inside is not known\n",
                report.layers_without_contour);
  if (!report.is_worth_it) std::printf("so few new drops may not be worth printing with them\n");
}

void printJson(const DropVoidReport& report, const std::vector<DropSweepStep>& steps,
               const DropFillFiles& files) {
  nlohmann::ordered_json json = toJson(report);
  if (!files.output.empty()) json["output"] = files.output;
  if (!files.sweep.empty()) {
    nlohmann::ordered_json rows = nlohmann::json::array();
    for (const DropSweepStep& step : steps) rows.push_back(toJson(step));
    json["sweep"] = rows;
    json["sweep_output"] = files.sweep;
  }
  std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

void addTo(CLI::App& subcommand, DropFillArguments& arguments) {
  const std::string group = "Programs of drops";
  subcommand.add_option("--overlap", arguments.overlap, "Overlap of a new drop with any other: 0.2")
      ->group(group);
  subcommand.add_option("--definition", arguments.definition, "Overlap as a share of: linear or area")
      ->group(group);
  subcommand.add_option("--detector", arguments.detector, "How voids are found: voronoi or neighbours")
      ->group(group);
  subcommand.add_flag("--iterate", arguments.iterates, "Search again until no drop finds room")->group(group);
  subcommand
      .add_option("--sweep", arguments.sweep, "Table to write (.csv): what overlaps from 0 to 0.4 would do")
      ->group(group);
}

std::vector<SettingText> overridesOf(const DropFillArguments& arguments) {
  std::vector<SettingText> overrides;
  if (!arguments.overlap.empty()) overrides.push_back({"drop_voids.overlap", arguments.overlap});
  if (!arguments.definition.empty()) overrides.push_back({"drop_voids.definition", arguments.definition});
  if (!arguments.detector.empty()) overrides.push_back({"drop_voids.detector", arguments.detector});
  if (arguments.iterates) overrides.push_back({"drop_voids.passes", "until_full"});
  return overrides;
}

void fillDropVoids(const DropFillFiles& files, const JobSettings& settings, OutputFormat format) {
  const DropDialect& dialect = settings.program.drops;
  const DropProgram program = parseDropProgram(readTextFile(files.program), dialect);
  FilledDropProgram filled;
  std::vector<DropSweepStep> steps;
  {
    TerminalProgress progress;
    filled = fillDropProgram(program, settings.drop_voids, dialect, progress);
    if (!files.sweep.empty()) steps = sweepDropVoids(program, settings.drop_voids, progress);
  }
  if (!files.output.empty()) writeFile(files.output, filled.text);
  if (!files.sweep.empty()) writeFile(files.sweep, sweepCsv(steps));
  if (format == OutputFormat::Json) return printJson(filled.report, steps, files);
  printText(filled.report);
  if (!steps.empty()) printText(steps);
  for (const std::string& written : {files.output, files.sweep})
    if (!written.empty()) std::printf("written to  %s\n", written.c_str());
}

}  // namespace lamina::cli
