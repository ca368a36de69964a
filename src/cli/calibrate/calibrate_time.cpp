// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/calibration/time_offset.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina calibrate time` as it was typed.
struct TimeArguments {
  CalibrateArguments common;
  std::string method = "bobbing";
};

TimeOffset offsetBy(const TimeArguments& arguments, const SensorRecording& recording, const Calibration& cell,
                    const CalibrateSettings& settings) {
  if (arguments.method == "bobbing") return offsetByBobbing(recording, settings.calibration.search_s);
  PassComparison comparison;
  comparison.search_s = settings.calibration.search_s;
  comparison.nozzle_from_sensor = knownSensorPose(cell, settings.machine);
  return offsetByPasses(recording, comparison);
}

void printTime(const TimeArguments& arguments, const TimeOffset& offset, OutputFormat format) {
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
  std::printf("time offset %.3f ms by %s: true time is the stamp less that\n", offset.offset_s * 1e3,
              arguments.method.c_str());
  std::printf("spread      %.3f ms; %.3f ms from piece to piece of %zu; drift %.3f ms/min\n",
              offset.spread_s * 1e3, offset.scatter_s * 1e3, offset.pieces_s.size(),
              offset.drift_s_per_min * 1e3);
  std::printf("agreement   %.4f over %zu profiles\n", offset.agreement, offset.profiles);
  if (arguments.method == "overlap" && !offset.is_skew_known)
    std::printf("caution     swaths lie to one side only: a turn of the sensor's line counts as time\n");
  if (!arguments.common.cell.empty()) std::printf("written to  %s\n", arguments.common.cell.c_str());
}

void calibrateTime(const TimeArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.common.settings);
  Calibration cell = cellSoFar(arguments.common, settings.machine);
  const TimeOffset offset = offsetBy(arguments, recordingFrom(arguments.common.recording), cell, settings);
  cell.time = CalibratedTime{offset.offset_s, offset.spread_s, offset.scatter_s, offset.drift_s_per_min,
                             foundNow(arguments.method)};
  keepCell(arguments.common, cell);
  printTime(arguments, offset, format);
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
