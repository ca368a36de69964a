// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/calibration/cell_findings.hpp"

namespace lamina::cli {
namespace {

void printFeeder(const CalibrateArguments& arguments, const FoundFeeder& found, OutputFormat format) {
  const FeederFit& fit = found.fit;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"dead_time_s", fit.dead_time_s},
                                         {"dead_time_spread_s", fit.dead_time_spread_s},
                                         {"lag_s", fit.lag_s},
                                         {"lag_spread_s", fit.lag_spread_s},
                                         {"gain", fit.gain},
                                         {"shift_mm", fit.shift_mm},
                                         {"rms", fit.rms},
                                         {"sections", fit.sections},
                                         {"output", arguments.cell}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  for (const std::string& sentence : inWords(found)) std::printf("%s\n", sentence.c_str());
  if (!arguments.cell.empty()) std::printf("written to  %s\n", arguments.cell.c_str());
}

void calibrateFeeder(const CalibrateArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments);
  Calibration cell = cellSoFar(arguments, settings.machine);
  const FoundFeeder found =
      findFeeder(recordingFrom(arguments.recording), knownSensorPose(cell, settings.machine),
                 timeOffsetOf(cell), settings.calibration, foundNow("bead").date);
  cell.feeder = found.feeder;
  keepCell(arguments, cell);
  printFeeder(arguments, found, format);
}

}  // namespace

void addCalibrateFeeder(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "feeder", "How late a feeder follows: from a scan of the beads of `calibrate plan feeder`");
  const auto arguments = std::make_shared<CalibrateArguments>();
  addCalibrateOptions(*subcommand, *arguments);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateFeeder(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
