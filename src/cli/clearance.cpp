// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/clearance.hpp"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "arguments/toolpath_input.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr int kCollides = 2;  // 1 is that of a check that could not be made

/// The command line of `lamina clearance` as it was typed.
struct ClearanceArguments {
  std::string input;
  std::string machine;
  SettingOptions settings;
};

nlohmann::ordered_json toJson(const Point3& point) { return {point.x(), point.y(), point.z()}; }

nlohmann::ordered_json toJson(const Collision& collision) {
  nlohmann::ordered_json json = {{"layer", collision.at.layer},
                                 {"path", collision.at.path},
                                 {"waypoint", collision.at.waypoint},
                                 {"tip_mm", toJson(collision.tip)},
                                 {"link", collision.link},
                                 {"obstacle", toString(collision.obstacle)},
                                 {"at_mm", toJson(collision.place)}};
  if (collision.obstacle == Obstacle::Material)
    json["deposited"] = {{"layer", collision.deposited.layer},
                         {"path", collision.deposited.path},
                         {"waypoint", collision.deposited.waypoint}};
  return json;
}

void printJson(const ClearanceReport& report, const std::string& machine) {
  nlohmann::ordered_json json = {{"machine", machine},
                                 {"waypoints", report.waypoints},
                                 {"colliding_waypoints", report.colliding},
                                 {"colliding_layers", report.first_of_layers.size()}};
  json["first"] = nullptr;
  if (report.colliding > 0) json["first"] = toJson(report.first_of_layers.front());
  std::printf("%s\n", json.dump(2).c_str());
}

void printFirst(const Collision& first) {
  std::printf("first       layer %zu, path %zu, waypoint %zu, nozzle tip at (%.3f, %.3f, %.3f) mm\n",
              first.at.layer, first.at.path, first.at.waypoint, first.tip.x(), first.tip.y(), first.tip.z());
  std::printf("            link '%s' is in ", first.link.c_str());
  if (first.obstacle == Obstacle::Bed)
    std::printf("the bed\n");
  else
    std::printf("what was deposited at layer %zu, path %zu, waypoint %zu, near (%.3f, %.3f, %.3f) mm\n",
                first.deposited.layer, first.deposited.path, first.deposited.waypoint, first.place.x(),
                first.place.y(), first.place.z());
}

void printText(const ClearanceReport& report, const std::string& machine) {
  std::printf("machine     %s\n", machine.c_str());
  std::printf("waypoints   %zu\n", report.waypoints);
  std::printf("collisions  at %zu of them, in %zu layers\n", report.colliding, report.first_of_layers.size());
  if (report.colliding > 0) printFirst(report.first_of_layers.front());
}

void checkClearanceOf(const ClearanceArguments& arguments, Chosen& chosen) {
  SettingOptions options = arguments.settings;
  if (!arguments.machine.empty()) options.assignments.push_back("machine.name=" + arguments.machine);
  const JobSettings settings = jobSettingsFrom(options);
  validate(settings);
  const CartesianMachine machine = machineOf(settings.machine);
  const ToolpathInput input = readInclinedToolpath(arguments.input, settings);
  requireReachable(input.toolpath, input.bed_from_part, machine);
  ClearanceReport report;
  {
    TerminalProgress progress;
    report = checkClearance({input.toolpath, input.bed_from_part, machine}, settings.clearance, progress);
  }
  if (report.colliding > 0) chosen.exit_code = kCollides;
  chosen.format == OutputFormat::Json ? printJson(report, machine.name) : printText(report, machine.name);
}

}  // namespace

void addClearance(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "clearance", "Check a machine's head against bed and deposited material; exits with 2 if it collides");
  const auto arguments = std::make_shared<ClearanceArguments>();
  subcommand
      ->add_option("input", arguments->input,
                   "Program (.gcode, .mod), toolpath (.csv), mesh file or name of a part")
      ->required();
  subcommand->add_option("--machine", arguments->machine, "Machine that runs it, as the setting machine.name")
      ->check(CLI::IsMember(machineNames()));
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing and reading");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { checkClearanceOf(*arguments, chosen); }; });
}

}  // namespace lamina::cli
