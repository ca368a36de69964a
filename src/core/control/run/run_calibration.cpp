// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/run_calibration.hpp"

#include <cmath>
#include <cstdio>
#include <optional>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string milliseconds(double seconds) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3f ms", 1e3 * seconds);
  return text;
}

std::string millimetres(double length_mm) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3f mm", length_mm);
  return text;
}

std::string inWords(const Point3& at) {
  char text[160];
  std::snprintf(text, sizeof text, "%.3f, %.3f, %.3f mm of the nozzle", at.x(), at.y(), at.z());
  return text;
}

/// "by bobbing on 2026-11-23T12:00:00Z, of 'cell.yaml'".
std::string foundBy(const CalibrationOrigin& origin, const std::string& file) {
  return "by " + origin.method + " on " + origin.date + ", of '" + file + "'";
}

std::string nowhere(const std::string& file) {
  return file.empty() ? "neither stated nor in a calibration" : "neither stated nor in '" + file + "'";
}

/// Keeps a value that was stated.
void fill(double& stated, double found) {
  if (stated == 0.0) stated = found;
}

std::string takeTime(CellCalibration& known, const std::optional<CalibratedTime>& time) {
  if (known.is_time_offset_trusted) {
    const std::string stated = "time offset of " + milliseconds(known.time_offset_s) + " as stated";
    return time ? stated + "; not the " + milliseconds(time->offset_s) + " found " +
                      foundBy(time->origin, known.file)
                : stated;
  }
  if (!time) return "time offset not known: " + nowhere(known.file);
  known.time_offset_s = time->offset_s;
  known.is_time_offset_trusted = true;
  fill(known.time_offset_sigma_s, time->spread_s);
  return "time offset of " + milliseconds(known.time_offset_s) + ", standard deviation " +
         milliseconds(known.time_offset_sigma_s) + ", " + foundBy(time->origin, known.file);
}

/// Off by which a point on the bed lies, below the sensor at the height of the nozzle tip.
double placeErrorOfPose(const CalibratedPose& pose) {
  const double distance_mm = std::abs(pose.nozzle_from_sensor.translation().z());
  const double turn = std::hypot(pose.spread[3], pose.spread[4]) * kDegree;
  return std::hypot(pose.spread[0], pose.spread[1], distance_mm * turn);
}

/// Whether the recordings say where on the bed the sensor sees: a pose of which only height and tilts were
/// found corrects the wrong cells.
bool isPlaceFound(const CalibratedPose& pose) {
  const std::string names = ", " + pose.not_found + ",";
  return names.find(", x,") == std::string::npos && names.find(", y,") == std::string::npos;
}

std::string takePose(LoopRunSettings& settings, const std::optional<CalibratedPose>& pose) {
  CellCalibration& known = settings.calibration;
  if (known.is_place_trusted) {
    const std::string stated = "place of the sensor as tf has it, as stated";
    return pose ? stated + "; not the one found " + foundBy(pose->origin, known.file) : stated;
  }
  if (!pose) return "place of the sensor not known: " + nowhere(known.file);
  known.nozzle_from_sensor = pose->nozzle_from_sensor;
  known.is_place_trusted = isPlaceFound(*pose);
  fill(known.place_error_mm, placeErrorOfPose(*pose));
  fill(settings.sight.pose_sigma_mm, pose->spread[2]);
  const std::string kept = pose->not_found.empty() ? "" : "; " + pose->not_found + " not found, as before";
  const std::string off =
      known.is_place_trusted
          ? ", off along the path by " + millimetres(known.place_error_mm) + ", "
          : ", which does not say where on the bed it sees: expected x and y to be found, ";
  return "sensor at " + inWords(pose->nozzle_from_sensor.translation()) + off +
         foundBy(pose->origin, known.file) + kept;
}

std::string takeFeeder(LoopRunSettings& settings, const std::optional<CalibratedFeeder>& feeder) {
  CellCalibration& known = settings.calibration;
  const auto delay = [](double dead_time_s, double lag_s) {
    return "dead time " + milliseconds(dead_time_s) + " and lag " + milliseconds(lag_s);
  };
  if (settings.loop.dead_time_s != 0.0 || settings.loop.lag_s != 0.0) {
    const std::string stated =
        "feeder's " + delay(settings.loop.dead_time_s, settings.loop.lag_s) + " as stated";
    return feeder ? stated + "; not the " + delay(feeder->dead_time_s, feeder->lag_s) + " found " +
                        foundBy(feeder->origin, known.file)
                  : stated;
  }
  if (!feeder) return "feeder taken to follow at once: its delay is " + nowhere(known.file);
  settings.loop.dead_time_s = feeder->dead_time_s;
  settings.loop.lag_s = feeder->lag_s;
  fill(known.feeder_uncertainty_s, std::hypot(feeder->dead_time_spread_s, feeder->lag_spread_s));
  return "feeder's " + delay(feeder->dead_time_s, feeder->lag_s) + ", off by " +
         milliseconds(known.feeder_uncertainty_s) + ", " + foundBy(feeder->origin, known.file);
}

}  // namespace

LoopRunSettings withCalibration(const LoopRunSettings& settings, const Calibration& found) {
  LoopRunSettings all = settings;
  CellCalibration& known = all.calibration;
  known.machine = found.machine;
  known.sources = {takeTime(known, found.time), takePose(all, found.pose), takeFeeder(all, found.feeder)};
  SettingsSchema schema;
  describe(schema, all);
  schema.validate();
  return all;
}

LoopRunSettings withCalibrationFile(const LoopRunSettings& settings) {
  const std::string& file = settings.calibration.file;
  return withCalibration(settings, file.empty() ? Calibration{} : readCalibration(file));
}

Calibration readCalibrationOf(const std::string& file, const std::string& machine) {
  Calibration found = readCalibration(file);
  if (found.machine != machine)
    throw InvalidConfig("the calibration '" + file + "' is that of machine '" + found.machine +
                        "'; expected that of '" + machine + "'");
  return found;
}

CalibratedFeeding withFeederOf(const std::string& file, const LoopSettings& loop,
                               const std::string& machine) {
  LoopRunSettings run;
  run.loop = loop;
  run.calibration.file = file;
  CalibratedFeeding feeding;
  feeding.source = takeFeeder(run, file.empty() ? std::nullopt : readCalibrationOf(file, machine).feeder);
  feeding.loop = run.loop;
  SettingsSchema schema;
  describeFeeding(schema, feeding.loop);
  schema.validate();
  return feeding;
}

/// A file of another machine says nothing of this one, so nothing of it may act.
StabilityReport checkStart(const Toolpath& toolpath, const std::string& machine,
                           const LoopRunSettings& settings) {
  StabilityReport report = checkStability(settings.loop, calibrationFor(toolpath, settings));
  const CellCalibration& known = settings.calibration;
  if (known.machine.empty() || known.machine == machine) return report;
  report.may_start = false;
  report.reason = "the calibration '" + known.file + "' is that of machine '" + known.machine +
                  "'; expected that of '" + machine + "', which the toolpath is for";
  return report;
}

}  // namespace lamina
