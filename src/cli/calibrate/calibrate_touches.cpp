// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "arguments/finite_number.hpp"
#include "calibrate/calibrated_cell.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/calibration/external_axis_fit.hpp"
#include "lamina/calibration/tool_centre.hpp"
#include "lamina/calibration/work_object.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/program/robot/robot_angles.hpp"
#include "output/point_json.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina calibrate tcp`, `object`, `positioner` and `rail` as it was typed.
struct TouchArguments {
  std::string table;
  std::string origin = "foot";
  double greatest_mm = 1.0;
  bool drops = false;  ///< touches that contradict the others
};

/// How touches agree with what was found of them.
struct TouchReport {
  std::size_t touches = 0;
  double rms_mm = 0.0;
  double greatest_mm = 0.0;
  std::size_t greatest_line = 0;
  std::vector<std::size_t> outlying_lines;  ///< named, and left out if asked for
};

/// A fit to what was touched, and its report.
template <typename Fit>
struct FoundByTouch {
  Fit fit;
  TouchReport report;
};

/// The fit to all touches; or, where touches that contradict the others are dropped, to those.
template <typename Touch, typename FitTo>
auto foundBy(std::vector<Touch> touches, const TouchArguments& arguments, const FitTo& fitTo) {
  FoundByTouch<decltype(fitTo(touches))> found{fitTo(touches), {}};
  for (const std::size_t at : found.fit.outlying) found.report.outlying_lines.push_back(touches[at].line);
  if (arguments.drops && !found.fit.outlying.empty()) {
    const std::set<std::size_t> lines(found.report.outlying_lines.begin(), found.report.outlying_lines.end());
    touches.erase(std::remove_if(touches.begin(), touches.end(),
                                 [&](const Touch& touch) { return lines.count(touch.line) > 0; }),
                  touches.end());
    found.fit = fitTo(touches);
  }
  const auto& distances = found.fit.distances_mm;
  const auto greatest = std::max_element(distances.begin(), distances.end());
  found.report.touches = touches.size();
  found.report.rms_mm = found.fit.rms_mm;
  found.report.greatest_mm = *greatest;
  found.report.greatest_line = touches[static_cast<std::size_t>(greatest - distances.begin())].line;
  if (found.report.greatest_mm > arguments.greatest_mm)
    throw InvalidInput("'" + arguments.table + "' line " + std::to_string(found.report.greatest_line) +
                       ": the touch is " + numberText(found.report.greatest_mm) +
                       " mm off what all of them give; expected at most " +
                       numberText(arguments.greatest_mm) +
                       " mm (--greatest-mm; --drop leaves out those that contradict the others)");
  return found;
}

void printReport(const TouchReport& report, const TouchArguments& arguments) {
  std::printf("touches     %zu; RMS %.3f mm, greatest %.3f mm in line %zu\n", report.touches, report.rms_mm,
              report.greatest_mm, report.greatest_line);
  for (const std::size_t line : report.outlying_lines)
    std::printf("outlying    line %zu contradicts the others%s\n", line,
                arguments.drops ? ", and is left out" : "; --drop leaves it out");
}

nlohmann::ordered_json reportToJson(const TouchReport& report) {
  return {{"touches", report.touches},
          {"rms_mm", report.rms_mm},
          {"greatest_mm", report.greatest_mm},
          {"greatest_line", report.greatest_line},
          {"outlying_lines", report.outlying_lines}};
}

void calibrateTip(const TouchArguments& arguments, OutputFormat format) {
  const auto found =
      foundBy(flangePosesFromCsv(readTextFile(arguments.table), arguments.table), arguments, fitToolCentre);
  const ToolCentreFit& fit = found.fit;
  const Point3& tip = fit.flange_from_tip;
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"xyz_mm", pointToJson(tip)},
                                   {"spread_mm", pointToJson(fit.spread_mm)},
                                   {"point_mm", pointToJson(fit.base_from_point)},
                                   {"least_determined", fit.least_determined}};
    json.update(reportToJson(found.report));
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("tip         (%.3f, %.3f, %.3f) mm from the flange, each ± (%.3f, %.3f, %.3f) mm\n", tip.x(),
              tip.y(), tip.z(), fit.spread_mm.x(), fit.spread_mm.y(), fit.spread_mm.z());
  printReport(found.report, arguments);
  std::printf("cell file   tool: {xyz_mm: [%.3f, %.3f, %.3f]}\n", tip.x(), tip.y(), tip.z());
  std::printf("not found   how the tool is turned: touches of one point do not depend on it\n");
}

void printObject(const Eigen::Isometry3d& object, OutputFormat format,
                 const nlohmann::ordered_json& figures) {
  const Point3 at = object.translation();
  const Eigen::Quaterniond turn(object.linear());
  const RobotAngles angles = robotAngles(turn);
  const Point3 rpy_deg(angles.x_deg, angles.y_deg, angles.z_deg);
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"xyz_mm", pointToJson(at)},
                                   {"rpy_deg", pointToJson(rpy_deg)},
                                   {"quaternion_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}}};
    json.update(figures);
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("object      (%.3f, %.3f, %.3f) mm, quaternion (%.6f, %.6f, %.6f, %.6f)\n", at.x(), at.y(),
              at.z(), turn.w(), turn.x(), turn.y(), turn.z());
  std::printf("cell file   bed: {xyz_mm: [%.3f, %.3f, %.3f], rpy_deg: [%.4f, %.4f, %.4f]}\n", at.x(), at.y(),
              at.z(), rpy_deg.x(), rpy_deg.y(), rpy_deg.z());
}

void calibrateAxes(const std::vector<TouchedPoint>& points, const TouchArguments& arguments,
                   OutputFormat format) {
  if (points.size() != 3)
    throw InvalidInput(
        "'" + arguments.table + "' has " + std::to_string(points.size()) +
        " points; expected 3, the first two along x and the third on the side of y, or columns "
        "object_x_mm, object_y_mm, object_z_mm");
  const ObjectOrigin origin = arguments.origin == "foot" ? ObjectOrigin::Foot : ObjectOrigin::First;
  printObject(workObjectOfAxes({points[0].base, points[1].base, points[2].base}, origin), format,
              {{"touches", points.size()}});
  if (format == OutputFormat::Text)
    std::printf("not found   how well the points agree: three determine the frame with nothing to spare\n");
}

void calibrateObject(const TouchArguments& arguments, OutputFormat format) {
  const std::vector<TouchedPoint> points =
      touchedPointsFromCsv(readTextFile(arguments.table), arguments.table);
  if (points.empty() || !points.front().object) return calibrateAxes(points, arguments, format);
  const auto found = foundBy(points, arguments, fitWorkObject);
  printObject(found.fit.base_from_object, format, reportToJson(found.report));
  if (format == OutputFormat::Text) printReport(found.report, arguments);
}

/// Roll, pitch and yaw [deg] of the least turn that leads z to a direction.
Point3 anglesOfAxis(const Point3& direction) {
  const RobotAngles angles = robotAngles(shortestRotation(Point3::UnitZ(), direction));
  return {angles.x_deg, angles.y_deg, angles.z_deg};
}

void calibratePositioner(const TouchArguments& arguments, OutputFormat format) {
  const auto found = foundBy(axisTouchesFromCsv(readTextFile(arguments.table), "angle_deg", arguments.table),
                             arguments, fitTurningAxis);
  const TurningAxisFit& fit = found.fit;
  const Point3 rpy_deg = anglesOfAxis(fit.direction);
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"axis", pointToJson(fit.direction)},
                                   {"centre_mm", pointToJson(fit.centre)},
                                   {"rpy_deg", pointToJson(rpy_deg)},
                                   {"radius_mm", fit.radius_mm},
                                   {"axis_spread_deg", fit.direction_spread_deg},
                                   {"centre_spread_mm", fit.centre_spread_mm}};
    json.update(reportToJson(found.report));
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("axis        (%.6f, %.6f, %.6f) in the base, ± %.4f deg\n", fit.direction.x(),
              fit.direction.y(), fit.direction.z(), fit.direction_spread_deg);
  std::printf("centre      (%.3f, %.3f, %.3f) mm in the base, ± %.3f mm; the mark is %.3f mm off the axis\n",
              fit.centre.x(), fit.centre.y(), fit.centre.z(), fit.centre_spread_mm, fit.radius_mm);
  printReport(found.report, arguments);
  std::printf(
      "cell file   positioner: {xyz_mm: [%.3f, %.3f, %.3f], rpy_deg: [%.4f, %.4f, %.4f]}, of one that turns "
      "about z of its root\n",
      fit.centre.x(), fit.centre.y(), fit.centre.z(), rpy_deg.x(), rpy_deg.y(), rpy_deg.z());
  std::printf("not found   its height along the axis, which is that of the mark, and where it is at 0\n");
}

void calibrateRail(const TouchArguments& arguments, OutputFormat format) {
  const auto found = foundBy(axisTouchesFromCsv(readTextFile(arguments.table), "rail_mm", arguments.table),
                             arguments, fitRail);
  const RailFit& fit = found.fit;
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json json = {{"axis", pointToJson(fit.direction)},
                                   {"way_per_value", fit.way_per_value},
                                   {"axis_spread_deg", fit.direction_spread_deg}};
    json.update(reportToJson(found.report));
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("axis        (%.6f, %.6f, %.6f) in the base, ± %.4f deg\n", fit.direction.x(),
              fit.direction.y(), fit.direction.z(), fit.direction_spread_deg);
  std::printf("way         %.6f mm for each millimetre that is shown\n", fit.way_per_value);
  printReport(found.report, arguments);
  std::printf("cell file   rail: {axis: [%.6f, %.6f, %.6f]}\n", fit.direction.x(), fit.direction.y(),
              fit.direction.z());
}

std::shared_ptr<TouchArguments> addTouchOptions(CLI::App& subcommand, const std::string& columns) {
  auto arguments = std::make_shared<TouchArguments>();
  subcommand.add_option("table", arguments->table, "Table of the touches: " + columns)->required();
  subcommand.add_flag("--drop", arguments->drops, "Leave out touches that contradict the others");
  subcommand
      .add_option("--greatest-mm", arguments->greatest_mm,
                  "Greatest distance of a touch from what is found [mm]")
      ->check(CLI::PositiveNumber)
      ->check(requireFinite)
      ->capture_default_str();
  return arguments;
}

}  // namespace

void addCalibrateTip(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand =
      calibrate.add_subcommand("tcp", "Where the tip of a robot's tool is, by a fixed point that it touches");
  const auto arguments = addTouchOptions(
      *subcommand,
      "x_mm, y_mm, z_mm of the flange in the base, and qw, qx, qy, qz or rx_deg, ry_deg, rz_deg");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateTip(*arguments, chosen.format); };
  });
}

void addCalibrateObject(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "object", "Where bed or work object are, by three points on their axes, or by known points");
  const auto arguments = addTouchOptions(
      *subcommand,
      "x_mm, y_mm, z_mm of the tip in the base; and object_x_mm, object_y_mm, object_z_mm of known points");
  subcommand
      ->add_option("--origin", arguments->origin,
                   "Of three points: foot of the third on the line through the others, or the first")
      ->check(CLI::IsMember({"foot", "first"}))
      ->capture_default_str();
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateObject(*arguments, chosen.format); };
  });
}

void addCalibratePositioner(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "positioner", "About which axis a positioner turns, by a mark on its plate at several angles");
  const auto arguments = addTouchOptions(
      *subcommand, "angle_deg of the axis, and x_mm, y_mm, z_mm of the tip in the base, on the mark");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibratePositioner(*arguments, chosen.format); };
  });
}

void addCalibrateRail(CLI::App& calibrate, Chosen& chosen) {
  CLI::App* subcommand = calibrate.add_subcommand(
      "rail", "Along which axis a rail carries a robot, by a mark in the room at several values");
  const auto arguments = addTouchOptions(
      *subcommand, "rail_mm, and x_mm, y_mm, z_mm of the tip in the base that the rail carries, on the mark");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] { calibrateRail(*arguments, chosen.format); };
  });
}

}  // namespace lamina::cli
