// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/calibration_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lamina/base/angle.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/settings_yaml.hpp"

namespace lamina {
namespace {

/// All that a file can state, as it states it.
struct StatedCalibration {
  std::string machine;
  std::string sensor;
  CalibratedTime time;
  CalibratedPose pose;
  std::vector<double> place_mm;
  std::vector<double> turn_deg;  ///< roll, pitch, yaw
  CalibratedFeeder feeder;
};

void describeOrigin(SettingsSchema& schema, const std::string& key, CalibrationOrigin& origin) {
  schema.text(key + "_method", origin.method, "How it was found.");
  schema.text(key + "_date", origin.date, "When it was found, UTC.");
}

/// Keys of a part begin alike.
constexpr char kTimeKeys[] = "sensor.time_offset";
constexpr char kPoseKeys[] = "sensor.pose";
constexpr char kFeederKeys[] = "feeder.delay";

void describe(SettingsSchema& schema, StatedCalibration& stated) {
  const Bounds offset{-1000.0, 1000.0};
  const Bounds spread{0.0, 1000.0};
  schema.text("calibration.machine", stated.machine, "Machine that was calibrated.");
  schema.text("calibration.sensor", stated.sensor, "Name or serial number of the sensor.");
  schema.number("sensor.time_offset_s", stated.time.offset_s, offset, "True time is the stamp less this.");
  schema.number("sensor.time_offset_spread_s", stated.time.spread_s, spread, "Its standard deviation.");
  schema.number("sensor.time_offset_scatter_s", stated.time.scatter_s, spread,
                "Standard deviation from piece to piece of the recording.");
  schema.number("sensor.time_offset_drift_s_per_min", stated.time.drift_s_per_min, offset,
                "Its change over the recording.");
  describeOrigin(schema, kTimeKeys, stated.time.origin);
  schema.numbers("sensor.pose_xyz_mm", stated.place_mm, 3, "The sensor's origin, seen from the nozzle.");
  schema.numbers("sensor.pose_rpy_deg", stated.turn_deg, 3,
                 "Its turn from the nozzle's frame: roll, pitch, yaw as in URDF.");
  schema.numbers("sensor.pose_spread", stated.pose.spread, 6,
                 "Standard deviations: x, y, z [mm], turns about them [deg]; 0 for what was never found.");
  schema.text("sensor.pose_kept", stated.pose.not_found, "What was never found and kept its former value.");
  describeOrigin(schema, kPoseKeys, stated.pose.origin);
  schema.number("feeder.delay_dead_time_s", stated.feeder.dead_time_s, spread,
                "Dead time of feeder and link.");
  schema.number("feeder.delay_dead_time_spread_s", stated.feeder.dead_time_spread_s, spread,
                "Its standard deviation.");
  schema.number("feeder.delay_lag_s", stated.feeder.lag_s, spread, "First-order lag of the feeder.");
  schema.number("feeder.delay_lag_spread_s", stated.feeder.lag_spread_s, spread, "Its standard deviation.");
  describeOrigin(schema, kFeederKeys, stated.feeder.origin);
}

bool belongsTo(const std::string& key, const std::string& part) {
  return key.compare(0, part.size(), part) == 0;
}

/// Whether a part is stated.
/// @throws InvalidConfig if it is stated in part
bool isStated(const std::string& part, const std::set<std::string>& keys, const SettingsSchema& schema,
              const std::string& source) {
  const auto isOfPart = [&](const std::string& key) { return belongsTo(key, part); };
  if (std::none_of(keys.begin(), keys.end(), isOfPart)) return false;
  for (const Setting& setting : schema.settings())
    if (belongsTo(setting.key, part) && keys.count(setting.key) == 0)
      throw InvalidConfig("'" + source + "' has no '" + setting.key +
                          "'; expected it beside the others of its part");
  return true;
}

void requireOrigin(const CalibrationOrigin& stated, const char* part, const std::string& source) {
  if (stated.method.empty() || stated.date.empty())
    throw InvalidConfig("'" + source + "': method or date of '" + part + "' is empty; expected both");
}

void requireCount(const std::vector<double>& numbers, std::size_t count, const char* key,
                  const std::string& source) {
  if (numbers.size() != count)
    throw InvalidConfig("'" + source + "': '" + key + "' holds " + std::to_string(numbers.size()) +
                        " numbers; expected " + std::to_string(count));
}

/// Roll, pitch and yaw about fixed axes, in that order.
Eigen::Matrix3d turnOfRpy(const std::vector<double>& rpy_deg) {
  const auto about = [&](std::size_t i, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(rpy_deg[i] * kDegree, axis);
  };
  return (about(2, Eigen::Vector3d::UnitZ()) * about(1, Eigen::Vector3d::UnitY()) *
          about(0, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

std::vector<double> rpyDegrees(const Eigen::Matrix3d& turn) {
  const double pitch = std::atan2(-turn(2, 0), std::hypot(turn(0, 0), turn(1, 0)));
  double roll = std::atan2(turn(2, 1), turn(2, 2));
  double yaw = std::atan2(turn(1, 0), turn(0, 0));
  if (std::hypot(turn(0, 0), turn(1, 0)) < 1e-9) {  // roll and yaw are one turn
    yaw = 0.0;
    roll = std::atan2(-turn(1, 2), turn(1, 1));
  }
  return {roll / kDegree, pitch / kDegree, yaw / kDegree};
}

CalibratedPose poseOf(const StatedCalibration& stated, const std::string& source) {
  requireCount(stated.place_mm, 3, "sensor.pose_xyz_mm", source);
  requireCount(stated.turn_deg, 3, "sensor.pose_rpy_deg", source);
  requireCount(stated.pose.spread, 6, "sensor.pose_spread", source);
  CalibratedPose pose = stated.pose;
  pose.nozzle_from_sensor.translation() =
      Eigen::Vector3d(stated.place_mm[0], stated.place_mm[1], stated.place_mm[2]);
  pose.nozzle_from_sensor.linear() = turnOfRpy(stated.turn_deg);
  return pose;
}

StatedCalibration statedFrom(const Calibration& calibration) {
  StatedCalibration stated;
  stated.machine = calibration.machine;
  stated.sensor = calibration.sensor;
  if (calibration.time) stated.time = *calibration.time;
  if (calibration.pose) {
    stated.pose = *calibration.pose;
    const Eigen::Vector3d at = stated.pose.nozzle_from_sensor.translation();
    stated.place_mm = {at.x(), at.y(), at.z()};
    stated.turn_deg = rpyDegrees(stated.pose.nozzle_from_sensor.linear());
  }
  if (calibration.feeder) stated.feeder = *calibration.feeder;
  return stated;
}

}  // namespace

std::string toYaml(const Calibration& calibration) {
  StatedCalibration stated = statedFrom(calibration);
  SettingsSchema schema;
  describe(schema, stated);
  std::vector<SettingText> texts;
  for (const Setting& setting : schema.settings()) {
    const bool is_missing = (belongsTo(setting.key, kTimeKeys) && !calibration.time) ||
                            (belongsTo(setting.key, kPoseKeys) && !calibration.pose) ||
                            (belongsTo(setting.key, kFeederKeys) && !calibration.feeder);
    if (!is_missing) texts.push_back({setting.key, setting.get()});
  }
  return "# What lamina calibrate found of a cell.\n" + settingsToYaml(texts);
}

Calibration calibrationFromYaml(const std::string& yaml, const std::string& source) {
  StatedCalibration stated;
  SettingsSchema schema;
  describe(schema, stated);
  std::set<std::string> keys;
  const std::vector<SettingText> settings = settingsFromYaml(yaml, source);
  for (const SettingText& setting : settings) keys.insert(setting.key);
  // What names no machine is another file, of which nothing is quoted.
  if (keys.count("calibration.machine") == 0)
    throw InvalidConfig("'" + source + "' names no machine; expected 'calibration.machine'");
  for (const SettingText& setting : settings) schema.set(setting.key, setting.text);
  Calibration calibration{stated.machine, stated.sensor, {}, {}, {}};
  if (isStated(kTimeKeys, keys, schema, source)) {
    requireOrigin(stated.time.origin, kTimeKeys, source);
    calibration.time = stated.time;
  }
  if (isStated(kPoseKeys, keys, schema, source)) {
    requireOrigin(stated.pose.origin, kPoseKeys, source);
    calibration.pose = poseOf(stated, source);
  }
  if (isStated(kFeederKeys, keys, schema, source)) {
    requireOrigin(stated.feeder.origin, kFeederKeys, source);
    calibration.feeder = stated.feeder;
  }
  return calibration;
}

Calibration readCalibration(const std::string& path) {
  return calibrationFromYaml(readFile(path, kMostSettingsBytes), path);
}

void writeCalibration(const std::string& path, const Calibration& calibration) {
  writeFile(path, toYaml(calibration));
}

void requireCalibrationOf(const Calibration& calibration, const std::string& machine) {
  if (calibration.machine != machine)
    throw InvalidConfig("the calibration is that of machine '" + calibration.machine +
                        "'; expected that of '" + machine + "'");
}

}  // namespace lamina
