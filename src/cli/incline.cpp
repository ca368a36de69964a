// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/incline_arguments.hpp"
#include "lamina/job/incline_job.hpp"
#include "lamina/job/output_files.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

nlohmann::ordered_json toJson(const Box3& box) {
  return {{"low_mm", {box.low.x(), box.low.y(), box.low.z()}},
          {"high_mm", {box.high.x(), box.high.y(), box.high.z()}}};
}

void printJson(const RewriteReport& report, const std::string& output, double seconds) {
  nlohmann::ordered_json json = {{"slicer", report.slicer},
                                 {"lines", report.lines},
                                 {"layers", report.layers},
                                 {"motions", report.motions},
                                 {"depositions", report.depositions},
                                 {"arcs", report.arcs},
                                 {"deferred", report.deferred},
                                 {"homings_annulled", report.homings_annulled},
                                 {"aids_dropped", report.aids_dropped},
                                 {"shift_mm", {report.shift.x(), report.shift.y(), report.shift.z()}},
                                 {"layer_height_mm", report.layer_height_mm},
                                 {"part", toJson(report.part)},
                                 {"stands_on_edge", standsOnEdge(report)},
                                 {"first_layer_gap_mm", report.first_layer_gap_mm},
                                 {"begins_in_air", beginsInAir(report)},
                                 {"tool_axis_off_normal_deg", report.tool_axis_off_normal_deg},
                                 {"nozzle", toJson(report.nozzle)},
                                 {"seconds", seconds},
                                 {"lines_per_s", static_cast<double>(report.lines) / seconds},
                                 {"output", output}};
  if (!report.footprint.isEmpty()) json["footprint"] = toJson(report.footprint);
  std::printf("%s\n", json.dump(2).c_str());
}

void printBox(const char* name, const Box3& box) {
  std::printf("%s  x %.3f to %.3f, y %.3f to %.3f, z %.3f to %.3f mm\n", name, box.low.x(), box.high.x(),
              box.low.y(), box.high.y(), box.low.z(), box.high.z());
}

void printText(const RewriteReport& report, const std::string& output, double seconds) {
  std::printf("program     %zu lines, %zu layers, of %s\n", report.lines, report.layers,
              report.slicer.empty() ? "an unnamed slicer" : report.slicer.c_str());
  std::printf("motions     %zu, %zu of them deposit; %zu arcs made chords, %zu deferred\n", report.motions,
              report.depositions, report.arcs, report.deferred);
  if (report.homings_annulled > 0)
    std::printf("homing      %zu lines annulled: the machine must be homed before\n",
                report.homings_annulled);
  if (report.aids_dropped > 0)
    std::printf("dropped     %zu motions of skirt, brim, raft or support\n", report.aids_dropped);
  std::printf("moved by    x %.3f, y %.3f, z %.3f mm\n", report.shift.x(), report.shift.y(),
              report.shift.z());
  printBox("part      ", report.part);
  if (!report.footprint.isEmpty()) printBox("stands on ", report.footprint);
  printBox("nozzle    ", report.nozzle);
  if (standsOnEdge(report))
    std::printf(
        "notice      the part stands on an edge: was the mesh tilted by the opposite angle before "
        "slicing?\n");
  if (beginsInAir(report)) std::printf("notice      %s\n", noticeOnFirstLayer(report).c_str());
  if (isToolAxisOffNormal(report))
    std::printf("notice      the machine holds its nozzle at %.2f deg from the normal of the layers\n",
                report.tool_axis_off_normal_deg);
  std::printf("computed in %.3f s, %.1f million lines per second\n", seconds,
              1e-6 * static_cast<double>(report.lines) / seconds);
  std::printf("written to  %s\n", output.c_str());
}

void incline(const InclineArguments& arguments, OutputFormat format) {
  if (arguments.prints_config) {
    InclineSettings settings;
    SettingsSchema schema;
    describe(schema, settings);
    return printConfig(schema, format);
  }
  InclineJob job = jobFrom(arguments);
  if (job.output.empty()) job.output = inclinedName(job.program);
  requireApart({job.output},
               {arguments.program, arguments.settings.config, arguments.begin_code, arguments.end_code});
  RewriteReport report;
  const auto begin = std::chrono::steady_clock::now();
  {
    TerminalProgress progress;
    report = runInclineJob(job, progress);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  format == OutputFormat::Json ? printJson(report, job.output, seconds.count())
                               : printText(report, job.output, seconds.count());
}

}  // namespace

void addIncline(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "incline", "Rotate the part of a program, or map it otherwise, so that its layers are inclined");
  const auto arguments = std::make_shared<InclineArguments>();
  addOptions(*subcommand, *arguments);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { incline(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
