// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/calibration/cell_findings.hpp"
#include "lamina/calibration/hand_eye.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina calibrate sensor` as it was typed.
struct SensorArguments {
  CalibrateArguments common;
  std::string method = "cross";
  std::vector<std::string> planes;    ///< recordings of planes that are fitted with it
  std::vector<double> pyramid_mm;     ///< base, top, height
  std::vector<double> pyramid_at_mm;  ///< x, y, as touched
  std::vector<double> top_mm;         ///< z of the top, as touched; none or one
};

nlohmann::ordered_json directionsOf(const SensorPoseFit& fit) {
  nlohmann::ordered_json directions = nlohmann::json::array();
  for (const ObservedDirection& direction : fit.directions)
    directions.push_back({{"singular_value", direction.singular_value}, {"share", direction.share}});
  return directions;
}

void printPose(const SensorArguments& arguments, const FoundPose& found, OutputFormat format,
               const nlohmann::ordered_json& figures) {
  const CalibratedPose& pose = found.pose;
  const Eigen::Vector3d at = pose.nozzle_from_sensor.translation();
  const Eigen::Quaterniond turn(pose.nozzle_from_sensor.linear());
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"method", arguments.method},
                                   {"xyz_mm", {at.x(), at.y(), at.z()}},
                                   {"quaternion_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
                                   {"spread", pose.spread},
                                   {"kept", pose.not_found},
                                   {"not_observable", found.not_observable},
                                   {"output", arguments.common.cell}};
    json.update(figures);
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  for (const std::string& sentence : inWords(found)) std::printf("%s\n", sentence.c_str());
  if (!arguments.common.cell.empty()) std::printf("written to  %s\n", arguments.common.cell.c_str());
}

void calibrateByPairs(const SensorArguments& arguments, Calibration cell, OutputFormat format) {
  const std::string& path = arguments.common.recording;
  const HandEyeFit fit = fitHandEye(sightsFromCsv(readTextFile(path), path));
  FoundPose found;
  found.pose.nozzle_from_sensor = fit.nozzle_from_sensor;
  found.pose.spread = {fit.rms_mm, fit.rms_mm, fit.rms_mm, fit.rms_deg, fit.rms_deg, fit.rms_deg};
  found.pose.origin = foundNow(arguments.method);
  found.fit.rms_mm = fit.rms_mm;
  cell.pose = found.pose;
  keepCell(arguments.common, cell);
  printPose(arguments, found, format,
            {{"rms_mm", fit.rms_mm},
             {"rms_deg", fit.rms_deg},
             {"turn_values", fit.rotation_singular_values},
             {"place_values", fit.place_values}});
}

void calibrateSensor(const SensorArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.common);
  Calibration cell = cellSoFar(arguments.common, settings.machine);
  if (arguments.method == "pairs") return calibrateByPairs(arguments, cell, format);
  std::vector<SensorView> views = {
      {sensorTarget(arguments.method, {arguments.pyramid_mm, arguments.pyramid_at_mm, arguments.top_mm},
                    settings.calibration),
       recordingFrom(arguments.common.recording)}};
  for (const std::string& plane : arguments.planes) views.push_back({PlaneTarget{}, recordingFrom(plane)});
  FoundPose found = findPose(views, knownSensorPose(cell, settings.machine), timeOffsetOf(cell),
                             settings.calibration, foundNow(arguments.method));
  found.pose = withFormer(found, cell.pose);
  cell.pose = found.pose;
  keepCell(arguments.common, cell);
  printPose(
      arguments, found, format,
      {{"rms_mm", found.fit.rms_mm}, {"points", found.fit.points}, {"directions", directionsOf(found.fit)}});
}

void addTargetOptions(CLI::App& subcommand, SensorArguments& arguments) {
  subcommand
      .add_option(
          "--method", arguments.method,
          "cross: beads of `calibrate plan cross`; pyramid; plane, at rest and anyhow; bed: the plane at "
          "height 0; pairs: a table of poses of nozzle and body in place of a recording")
      ->check(CLI::IsMember({"cross", "pyramid", "plane", "bed", "pairs"}))
      ->capture_default_str();
  subcommand
      .add_option("--with-plane", arguments.planes,
                  "Recording of a plane that is fitted with it, for tilts; may be repeated")
      ->allow_extra_args(false);
  subcommand
      .add_option("--pyramid", arguments.pyramid_mm, "Width of base and top, height of the pyramid [mm]")
      ->delimiter(',')
      ->expected(3);
  subcommand
      .add_option("--at", arguments.pyramid_at_mm, "Its middle x,y on the bed, as touched by the nozzle [mm]")
      ->delimiter(',')
      ->expected(2);
  subcommand.add_option("--top", arguments.top_mm, "Height of its top, as touched by the nozzle [mm]")
      ->expected(1);
}

}  // namespace

void addCalibrateSensor(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand("sensor", "Where the sensor sits, seen from the nozzle");
  const auto arguments = std::make_shared<SensorArguments>();
  addCalibrateOptions(*subcommand, arguments->common);
  addTargetOptions(*subcommand, *arguments);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateSensor(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
