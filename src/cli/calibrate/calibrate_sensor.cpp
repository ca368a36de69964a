// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/calibrated_cell.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/calibration/hand_eye.hpp"
#include "lamina/calibration/sensor_pose.hpp"

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

PyramidTarget pyramidFrom(const SensorArguments& arguments, const CalibrationSettings& settings) {
  PyramidTarget target;
  if (!arguments.pyramid_mm.empty()) {
    target.base_mm = arguments.pyramid_mm[0];
    target.top_mm = arguments.pyramid_mm[1];
    target.height_mm = arguments.pyramid_mm[2];
  }
  if (!(target.base_mm > target.top_mm && target.top_mm > 0.0 && target.height_mm > 0.0))
    throw InvalidConfig("the pyramid is " + std::to_string(target.base_mm) + " mm wide at its base, " +
                        std::to_string(target.top_mm) + " mm at its top and " +
                        std::to_string(target.height_mm) +
                        " mm high; expected a base wider than the top, and all above 0");
  Point3 at(settings.x_mm, settings.y_mm, 0.0);
  target.is_place_known = !arguments.pyramid_at_mm.empty();
  if (target.is_place_known) at.head<2>() = Point2(arguments.pyramid_at_mm[0], arguments.pyramid_at_mm[1]);
  target.is_top_known = !arguments.top_mm.empty();
  if (target.is_top_known) at.z() = arguments.top_mm[0] - target.height_mm;
  target.bed_from_pyramid.translation() = at;
  return target;
}

SensorTarget targetFrom(const SensorArguments& arguments, const CalibrationSettings& settings) {
  if (arguments.method == "pyramid") return pyramidFrom(arguments, settings);
  if (arguments.method == "cross")
    return CrossTarget{crossBeads(settings), settings.bead_width_mm, settings.bead_height_mm};
  return PlaneTarget{arguments.method == "bed"};
}

SensorPoseSettings poseSettings(const CalibrationSettings& settings, const Calibration& cell) {
  SensorPoseSettings pose;
  if (cell.time) pose.time_offset_s = cell.time->offset_s;
  pose.max_sigma_mm = settings.max_sigma_mm;
  pose.max_sigma_deg = settings.max_sigma_deg;
  pose.noise_mm = settings.noise_mm;
  return pose;
}

nlohmann::ordered_json directionsOf(const SensorPoseFit& fit) {
  nlohmann::ordered_json directions = nlohmann::json::array();
  for (const ObservedDirection& direction : fit.directions)
    directions.push_back({{"singular_value", direction.singular_value}, {"share", direction.share}});
  return directions;
}

void printPose(const SensorArguments& arguments, const CalibratedPose& pose, OutputFormat format,
               const nlohmann::ordered_json& figures, const std::vector<std::string>& sentences) {
  const Eigen::Vector3d at = pose.nozzle_from_sensor.translation();
  const Eigen::Quaterniond turn(pose.nozzle_from_sensor.linear());
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"method", arguments.method},
                                   {"xyz_mm", {at.x(), at.y(), at.z()}},
                                   {"quaternion_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
                                   {"spread", pose.spread},
                                   {"kept", pose.kept},
                                   {"not_observable", sentences},
                                   {"output", arguments.common.cell}};
    json.update(figures);
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("sensor      at %.3f, %.3f, %.3f mm of the nozzle, by %s\n", at.x(), at.y(), at.z(),
              arguments.method.c_str());
  std::printf("spread      %.4f, %.4f, %.4f mm; %.4f, %.4f, %.4f deg\n", pose.spread[0], pose.spread[1],
              pose.spread[2], pose.spread[3], pose.spread[4], pose.spread[5]);
  std::printf("points      %.4f mm rms from their target\n", figures["rms_mm"].get<double>());
  for (const std::string& sentence : sentences) std::printf("kept        %s\n", sentence.c_str());
  if (!arguments.common.cell.empty()) std::printf("written to  %s\n", arguments.common.cell.c_str());
}

void calibrateByPairs(const SensorArguments& arguments, Calibration cell, OutputFormat format) {
  const std::string& path = arguments.common.recording;
  const HandEyeFit fit = fitHandEye(sightsFromCsv(readFile(path), path));
  CalibratedPose pose;
  pose.nozzle_from_sensor = fit.nozzle_from_sensor;
  pose.spread = {fit.rms_mm, fit.rms_mm, fit.rms_mm, fit.rms_deg, fit.rms_deg, fit.rms_deg};
  pose.source = foundNow(arguments.method);
  cell.pose = pose;
  keepCell(arguments.common, cell);
  printPose(arguments, pose, format,
            {{"rms_mm", fit.rms_mm},
             {"rms_deg", fit.rms_deg},
             {"turn_values", fit.turn_values},
             {"place_values", fit.place_values}},
            {});
}

void calibrateSensor(const SensorArguments& arguments, OutputFormat format) {
  const CalibrateSettings settings = calibrateSettingsFrom(arguments.common.settings);
  Calibration cell = cellSoFar(arguments.common, settings.machine);
  if (arguments.method == "pairs") return calibrateByPairs(arguments, cell, format);
  std::vector<SensorView> views = {
      {targetFrom(arguments, settings.calibration), recordingFrom(arguments.common.recording)}};
  for (const std::string& plane : arguments.planes) views.push_back({PlaneTarget{}, recordingFrom(plane)});
  const SensorPoseSettings how = poseSettings(settings.calibration, cell);
  const SensorPoseFit fit = fitSensorPose(views, knownSensorPose(cell, settings.machine), how);
  CalibratedPose pose;
  pose.nozzle_from_sensor = fit.nozzle_from_sensor;
  pose.spread.assign(fit.sigma.begin(), fit.sigma.end());
  pose.kept = keptDirections(fit);
  pose.source = foundNow(arguments.method);
  cell.pose = pose;
  keepCell(arguments.common, cell);
  printPose(arguments, pose, format,
            {{"rms_mm", fit.rms_mm}, {"points", fit.points}, {"directions", directionsOf(fit)}},
            observability(fit, how));
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
