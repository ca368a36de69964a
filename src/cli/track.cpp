// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/dynamics/tracking_simulation.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina track` as it was typed.
struct TrackArguments {
  std::string toolpath;
  std::string urdf;
  std::vector<double> middle;
  SettingOptions settings;
};

/// What is set on the command line.
struct TrackSettings {
  TrackingSettings tracking;
  MotionLimits motion{1000.0, 1000.0, 0.0};  // of [Guacheta2021, section 4.2.3]
};

TrackSettings settingsFrom(const SettingOptions& options) {
  TrackSettings settings;
  SettingsSchema schema;
  describe(schema, settings.tracking);
  schema.number("motion.acceleration_mm_s2", settings.motion.acceleration_mm_s2, Bounds::above(0.0, 1e6),
                "Acceleration of the nozzle along the path.");
  applySettings(schema, options.config, overridesFrom(options.assignments));
  schema.validate();
  settings.motion.travel_acceleration_mm_s2 = settings.motion.acceleration_mm_s2;
  return settings;
}

/// Moves the middle of what is deposited to a place on the bed; its height stays.
Eigen::Isometry3d placement(const Toolpath& toolpath, const std::vector<double>& middle) {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  if (middle.empty()) return bed_from_part;
  const Point3 now = depositionBox(toolpath).centre();
  bed_from_part.translation() = Point3(middle[0] - now.x(), middle[1] - now.y(), 0.0);
  return bed_from_part;
}

void printText(const TrackingFigures& report) {
  std::printf("duration    %.3f s, from rest to rest at every waypoint\n", report.duration_s);
  std::printf("tip         %.6g mm2 s of squared error, %.4f mm at most\n", report.linear_ise_mm2_s,
              report.greatest_tip_error_mm);
  std::printf("turn        %.6g rad2 s of squared error, %.6f rad at most\n", report.rotational_ise_rad2_s,
              report.greatest_turn_error_rad);
  std::printf("cranks      %.6f rad of error at most\n", report.greatest_crank_error_rad);
  std::printf("torques     %.6g (N m)2 s of control energy, %.3f N m at most\n", report.control_energy_nm2_s,
              report.greatest_torque_nm);
}

void printJson(const TrackingFigures& report) {
  const nlohmann::ordered_json json = {{"duration_s", report.duration_s},
                                       {"linear_ise_mm2_s", report.linear_ise_mm2_s},
                                       {"rotational_ise_rad2_s", report.rotational_ise_rad2_s},
                                       {"control_energy_nm2_s", report.control_energy_nm2_s},
                                       {"greatest_torque_nm", report.greatest_torque_nm},
                                       {"greatest_tip_error_mm", report.greatest_tip_error_mm},
                                       {"greatest_turn_error_rad", report.greatest_turn_error_rad},
                                       {"greatest_crank_error_rad", report.greatest_crank_error_rad}};
  std::printf("%s\n", json.dump(2).c_str());
}

void track(const TrackArguments& arguments, OutputFormat format) {
  const TrackSettings settings = settingsFrom(arguments.settings);
  const std::string urdf =
      arguments.urdf.empty() ? kinematicModelByName("rus_platform")->urdf() : readTextFile(arguments.urdf);
  const RusDescription platform = rusDescriptionFromUrdf(urdf);
  const Toolpath toolpath = readCsv(readTextFile(arguments.toolpath), arguments.toolpath);
  const ToolpathReference reference(toolpath, placement(toolpath, arguments.middle), settings.motion,
                                    platform);
  TrackingFigures report;
  {
    TerminalProgress progress;
    report =
        simulateTracking(TrackingSimulation(reference, platform.platform,
                                            platform.platform_from_nozzle.translation(), settings.tracking),
                         progress);
  }
  format == OutputFormat::Json ? printJson(report) : printText(report);
}

}  // namespace

void addTrack(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "track", "Simulate how the six-legged platform follows a toolpath under its controller");
  const auto arguments = std::make_shared<TrackArguments>();
  subcommand->add_option("toolpath", arguments->toolpath, "Toolpath (.csv) in coordinates of the bed")
      ->required();
  subcommand->add_option("--urdf", arguments->urdf, "Description of another platform of six cranks");
  subcommand
      ->add_option("--middle", arguments->middle,
                   "Where the middle of what is deposited goes on the bed, x,y in mm; without it, it stays")
      ->delimiter(',')
      ->expected(2);
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) of platform, controller and motion");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { track(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
