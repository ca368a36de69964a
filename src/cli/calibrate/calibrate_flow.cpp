// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/calibration/flow_trial.hpp"

namespace lamina::cli {
namespace {

constexpr double kSurely = 3.0;  // standard deviations
constexpr std::size_t kMostReadingBytes = std::size_t{1} << 24;

/// Why the readings are to be doubted; empty if they need not be.
std::string cautionOn(const FlowFit& fit) {
  if (std::abs(fit.follows - 1.0) <= kSurely * fit.follows_spread) return "";
  return fit.follows < 1.0
             ? "the walls follow the multipliers by less than what is extruded: readings that are all too "
               "thick, or a feeder that slips"
             : "the walls follow the multipliers by more than what is extruded: readings that are all "
               "too thin";
}

void printFlow(const FlowFit& fit, double flow, OutputFormat format) {
  const std::string caution = cautionOn(fit);
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {
        {"flow", flow * fit.factor}, {"flow_spread", flow * fit.factor_spread},
        {"share", fit.share},        {"share_spread", fit.share_spread},
        {"follows", fit.follows},    {"follows_spread", fit.follows_spread},
        {"rms_mm2", fit.rms_mm2},    {"readings", fit.readings},
        {"caution", caution}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("extruded      %.3f +- %.3f of what was asked for, by %zu readings\n", fit.share,
              fit.share_spread, fit.readings);
  std::printf("program.flow  %.3f +- %.3f instead of %.4g\n", flow * fit.factor, flow * fit.factor_spread,
              flow);
  std::printf("follows       %.2f +- %.2f of what the multipliers change\n", fit.follows, fit.follows_spread);
  if (!caution.empty()) std::printf("caution       %s\n", caution.c_str());
}

void calibrateFlow(const CalibrateArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments);
  requireConsistent(settings.flow_trial);
  const std::string table = readFile(arguments.recording, kMostReadingBytes);
  const FlowFit fit =
      fitFlow(flowReadings(table, arguments.recording, settings.flow_trial), settings.flow_trial);
  printFlow(fit, settings.program.flow, format);
}

}  // namespace

void addCalibrateFlow(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "flow", "How much is extruded of what is asked for: from the walls of `calibrate plan flow`");
  const auto arguments = std::make_shared<CalibrateArguments>();
  subcommand
      ->add_option("readings", arguments->recording,
                   "Table (CSV) with the columns multiplier and thickness_mm, or section_mm2")
      ->required();
  addCalibratedMachine(*subcommand, *arguments);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateFlow(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
