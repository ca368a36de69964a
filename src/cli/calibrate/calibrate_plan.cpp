// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/calibration/calibration_program.hpp"
#include "lamina/calibration/flow_trial.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/output_writer.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"

namespace lamina::cli {
namespace {

constexpr double kUprightCosine = 0.9999;

/// The command line of `lamina calibrate plan` as it was typed.
struct PlanArguments {
  std::string kind;
  CalibrateArguments common;
  bool prints_config = false;
};

Toolpath planned(const std::string& kind, const CalibrateSettings& all, const BuildSpace& space) {
  if (kind == "flow") return flowTrialToolpath(all.flow_trial);
  const CalibrationSettings& settings = all.calibration;
  const Point2 sensor_offset = sensorOffset(space);
  if (kind == "bobbing") return bobbingToolpath(settings, sensor_offset);
  if (kind == "edge") return edgeToolpath(settings, sensor_offset);
  if (kind == "cross") return crossToolpath(settings, sensor_offset);
  return feederToolpath(settings, sensor_offset);
}

void printPlan(const PlanArguments& arguments, const Toolpath& toolpath, const FlowTrialSettings& trial,
               OutputFormat format) {
  const ToolpathTotals sums = totals(toolpath);
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"plan", arguments.kind},
                                   {"output", arguments.common.cell},
                                   {"deposition_mm", sums.deposition_mm},
                                   {"travel_mm", sums.travel_mm},
                                   {"deposited_mm3", sums.deposited_mm3}};
    if (arguments.kind == "flow") json["multipliers"] = flowMultipliers(trial);
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s: %s, %.1f mm of bead, %.2f m of travel\n", arguments.common.cell.c_str(),
              arguments.kind.c_str(), sums.deposition_mm, sums.travel_mm / 1e3);
  if (arguments.kind != "flow") return;
  std::string multipliers;
  for (const double multiplier : flowMultipliers(trial))
    multipliers += (multipliers.empty() ? "" : ", ") + numberText(multiplier);
  std::printf("multipliers of the flow, towards +x: %s\n", multipliers.c_str());
}

void plan(const PlanArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.common);
  const std::string& output = arguments.common.cell;
  if (output.empty()) throw InvalidConfig("no output named; expected -o FILE.gcode or FILE.csv");
  requireSuffix(output, outputSuffixes());
  requireApart({output}, {arguments.common.settings.config});
  const BuildSpace space = buildSpaceOf(settings.machine);
  if (!(-toolAxis(space).z() > kUprightCosine))
    throw InvalidConfig("the nozzle of machine '" + space.name +
                        "' does not point straight down; calibration programs expect that");
  const Toolpath toolpath = planned(arguments.kind, settings, space);
  validate(toolpath);
  requireReachable(toolpath, Eigen::Isometry3d::Identity(), space);
  writeOutput(output, {toolpath, {}}, settings.program);
  printPlan(arguments, toolpath, settings.flow_trial, format);
}

void printPlanConfig(const CalibrateArguments& arguments, OutputFormat format) {
  CalibrateSettings settings = calibrateSettingsFrom(arguments);
  SettingsSchema schema;
  describe(schema, settings.machine, "Machine that is calibrated.");
  describe(schema, settings.calibration);
  describe(schema, settings.flow_trial);
  describe(schema, settings.program);
  printConfig(schema, format);
}

}  // namespace

void addCalibratePlan(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "plan",
      "Write the program of motions and beads that a calibration needs: bobbing, edge, cross, feeder, flow");
  const auto arguments = std::make_shared<PlanArguments>();
  subcommand->add_option("kind", arguments->kind, "bobbing, edge, cross, feeder or flow")
      ->check(CLI::IsMember({"bobbing", "edge", "cross", "feeder", "flow"}))
      ->required();
  subcommand->add_option("-o,--output", arguments->common.cell, "Program to write (.gcode, .csv, .mod)");
  subcommand->add_flag("--print-config", arguments->prints_config, "Print the settings instead");
  addCalibratedMachine(*subcommand, arguments->common);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] {
      arguments->prints_config ? printPlanConfig(arguments->common, chosen.format)
                               : plan(*arguments, chosen.format);
    };
  });
}

}  // namespace lamina::cli
