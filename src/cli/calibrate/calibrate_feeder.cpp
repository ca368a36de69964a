// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/calibration/feeder_fit.hpp"

namespace lamina::cli {
namespace {

void printFeeder(const CalibrateArguments& arguments, const FeederFit& fit, OutputFormat format) {
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
  std::printf("dead time   %.3f s, spread %.3f s\n", fit.dead_time_s, fit.dead_time_spread_s);
  std::printf("lag         %.3f s, spread %.3f s\n", fit.lag_s, fit.lag_spread_s);
  std::printf("sections    %zu, %.2f %% rms off; they follow the steps by %.3f\n", fit.sections,
              100.0 * fit.rms, fit.gain);
  std::printf("shift       %.3f mm of the scan against the program\n", fit.shift_mm);
  if (!arguments.cell.empty()) std::printf("written to  %s\n", arguments.cell.c_str());
}

void calibrateFeeder(const CalibrateArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.settings);
  Calibration cell = cellSoFar(arguments, settings.machine);
  const FeederSteps steps = feederSteps(settings.calibration);
  const double time_offset_s = cell.time ? cell.time->offset_s : 0.0;
  const auto beads = beadSections(recordingFrom(arguments.recording), knownSensorPose(cell, settings.machine),
                                  time_offset_s, steps);
  const FeederFit fit = fitFeeder(steps, beads, settings.calibration.feeder_mm_s);
  cell.feeder = CalibratedFeeder{fit.dead_time_s, fit.dead_time_spread_s, fit.lag_s, fit.lag_spread_s,
                                 foundNow("bead")};
  keepCell(arguments, cell);
  printFeeder(arguments, fit, format);
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
