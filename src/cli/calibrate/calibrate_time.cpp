// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/calibration/cell_findings.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina calibrate time` as it was typed.
struct TimeArguments {
  CalibrateArguments common;
  std::string method = "bobbing";
};

void printTime(const TimeArguments& arguments, const FoundTime& found, OutputFormat format) {
  const TimeOffset& offset = found.fit;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"method", arguments.method},
                                         {"time_offset_s", offset.offset_s},
                                         {"spread_s", offset.spread_s},
                                         {"scatter_s", offset.scatter_s},
                                         {"drift_s_per_min", offset.drift_s_per_min},
                                         {"agreement", offset.agreement},
                                         {"profiles", offset.profiles},
                                         {"pieces_s", offset.pieces_s},
                                         {"skew_deg", offset.skew_deg},
                                         {"output", arguments.common.cell}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  for (const std::string& sentence : inWords(found)) std::printf("%s\n", sentence.c_str());
  if (!arguments.common.cell.empty()) std::printf("written to  %s\n", arguments.common.cell.c_str());
}

void calibrateTime(const TimeArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.common);
  Calibration cell = cellSoFar(arguments.common, settings.machine);
  // Bobbing asks nothing of where the sensor sits, and does without a machine that says it.
  const Eigen::Isometry3d about =
      arguments.method == "bobbing" ? Eigen::Isometry3d::Identity() : knownSensorPose(cell, settings.machine);
  const FoundTime found = findTime(recordingFrom(arguments.common.recording), arguments.method, about,
                                   settings.calibration, foundNow(arguments.method).date);
  cell.time = found.time;
  keepCell(arguments.common, cell);
  printTime(arguments, found, format);
}

}  // namespace

void addCalibrateTime(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand("time", "How late the sensor's stamps are");
  const auto arguments = std::make_shared<TimeArguments>();
  addCalibrateOptions(*subcommand, arguments->common);
  subcommand
      ->add_option("--method", arguments->method,
                   "bobbing over a flat place; an edge there and back; swaths that overlap")
      ->check(CLI::IsMember({"bobbing", "edge", "overlap"}))
      ->capture_default_str();
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateTime(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
