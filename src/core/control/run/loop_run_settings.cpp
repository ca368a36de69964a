// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_run_settings.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

void describeCalibration(SettingsSchema& schema, CellCalibration& calibration) {
  schema.text("sensor.calibration", calibration.file,
              "File that `lamina calibrate` wrote, for what is not stated here; empty for none.");
  schema.number("sensor.time_offset_s", calibration.time_offset_s, {-60.0, 60.0},
                "Stamp of a cloud less the time at which it was taken.");
  schema.flag("sensor.time_offset_trusted", calibration.is_time_offset_trusted,
              "Whether that is known; else the loop is blocked.");
  schema.number("sensor.time_offset_sigma_s", calibration.time_offset_sigma_s, {0.0, 60.0},
                "Standard deviation of that.");
  schema.table("sensor.other_time_offsets_s", calibration.other_time_offsets_s,
               "The same of further sensors, by the frame of their clouds; those of others are left out.");
  schema.table("sensor.other_time_offset_sigmas_s", calibration.other_time_offset_sigmas_s,
               "Standard deviations of these; sensor.time_offset_sigma_s for those that are not listed.");
  schema.flag("sensor.place_trusted", calibration.is_place_trusted,
              "Whether tf holds the calibrated place of the sensor at the nozzle; else the loop is blocked.");
  schema.number("sensor.place_error_mm", calibration.place_error_mm, {0.0, 1000.0},
                "Error of that place along the path.");
  schema.number("feeder.uncertainty_s", calibration.feeder_uncertainty_s, {0.0, 60.0},
                "Error of the feeder's dead time and lag.");
  schema.number("process.levelling_mm", calibration.levelling_mm, {0.0, 1000.0},
                "Standard deviation of the process's own levelling; 0 if not known.");
  schema.number("process.standoff", calibration.standoff, {-10.0, 10.0},
                "Loss of growth per nozzle too far away, in layer heights.");
  schema.number("process.gain_ratio", calibration.gain_ratio, {0.01, 100.0},
                "Real over learnt growth, at worst.");
}

}  // namespace

void describe(SettingsSchema& schema, LoopRunSettings& settings) {
  schema.choice(
      "request", settings.request,
      {{"none", LoopRequest::Off}, {"identify", LoopRequest::Identify}, {"active", LoopRequest::Active}},
      "What a print begins with: no loop, learning only, or corrections.");
  describe(schema, settings.loop);
  schema.text("loop.learned", settings.learned,
              "Map learnt from parts before, which this part is deposited by; empty for none.");
  describe(schema, settings.sight);
  describe(schema, settings.following);
  describeCalibration(schema, settings.calibration);
  schema.text("process.material", settings.material,
              "Material that is deposited; what was learnt of another one is not gone on with.");
  schema.number("head.clearance_mm", settings.head_clearance_mm, {0.0, 1000.0},
                "Height of the head above the nozzle tip, which a lump may not reach.");
  schema.number("monitor.cell_mm", settings.cell_mm, Bounds::above(0.0, 100.0),
                "Length of a cell along a path at most.");
  schema.number("monitor.settle_mm", settings.settle_mm, {0.0, 1000.0},
                "Way by which the nozzle has left a cell behind before it is read; 0: a bead's width.");
  schema.number("monitor.settle_s", settings.settle_s, {0.0, 3600.0},
                "Time since then after which a cell is solid, and read.");
  schema.number("monitor.reorder_s", settings.reorder_s, {0.0, 60.0},
                "Time by the stamps for which poses and clouds wait for older ones.");
}

namespace {

std::map<std::string, double> numbersOf(const SettingTable& table, const std::string& key,
                                        const Bounds& bounds) {
  std::map<std::string, double> numbers;
  for (const auto& [frame, text] : table) {
    SettingsSchema schema;
    schema.number(key + "." + frame, numbers[frame], bounds, "");
    schema.set(key + "." + frame, text);
  }
  return numbers;
}

}  // namespace

std::map<std::string, double> otherTimeOffsets(const SettingTable& offsets_s) {
  return numbersOf(offsets_s, "sensor.other_time_offsets_s", {-60.0, 60.0});
}

TimeOffsetSigmas timeOffsetSigmas(const CellCalibration& calibration) {
  return {calibration.time_offset_sigma_s, numbersOf(calibration.other_time_offset_sigmas_s,
                                                     "sensor.other_time_offset_sigmas_s", {0.0, 60.0})};
}

double TimeOffsetSigmas::of(const std::string& frame) const {
  const auto other = others_s.find(frame.substr(frame.rfind('/', 0) == 0 ? 1 : 0));
  return other == others_s.end() ? calibrated_s : other->second;
}

double TimeOffsetSigmas::greatest() const {
  double greatest_s = calibrated_s;
  for (const auto& [frame, sigma_s] : others_s) greatest_s = std::max(greatest_s, sigma_s);
  return greatest_s;
}

LoopCalibration calibrationFor(const Toolpath& toolpath, const LoopRunSettings& settings) {
  const CellCalibration& known = settings.calibration;
  LoopCalibration calibration;
  calibration.has_time_offset = known.is_time_offset_trusted;
  calibration.has_sensor_place = known.is_place_trusted;
  calibration.delay_uncertainty_s =
      std::hypot(timeOffsetSigmas(known).greatest(), known.feeder_uncertainty_s);
  calibration.place_error_mm = known.place_error_mm;
  calibration.cell_mm = settings.cell_mm;
  calibration.levelling_mm = known.levelling_mm;
  calibration.standoff = known.standoff;
  calibration.gain_ratio = known.gain_ratio;
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel || kindOf(path.role) == RoleKind::BuildAid) continue;
      for (const Bead& bead : path.bead.values())
        calibration.bead_width_mm = std::max(calibration.bead_width_mm, bead.width_mm);
      for (const double feed : path.feed_mm_s.values())
        calibration.speed_mm_s = std::max(calibration.speed_mm_s, feed);
    }
  }
  return calibration;
}

}  // namespace lamina
