// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a machine runs to be calibrated, and what its recordings tell.
#include "calibration/recorded_cell.hpp"
#include "job/settings/setting_probe.hpp"
#include "lamina/calibration/cell_findings.hpp"
#include "lamina/calibration/flow_trial.hpp"

namespace lamina::test {
namespace {

using ToCalibrate = Toolpath (*)(const CalibrationSettings& settings, const Point2& sensor_offset);

/// Where the nozzle goes, how fast, and what it lays.
std::function<std::string(const SettingTexts& set)> motionsOf(ToCalibrate planned) {
  return [planned](const SettingTexts& set) {
    const Toolpath toolpath = planned(settingsWith<CalibrationSettings>(set), {25.0, 0.0});
    std::string text;
    for (const Path& path : toolpath.layers[0].paths)
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Point3& at = path.points[i];
        const Bead& bead = path.bead.at(i);
        text += numbersText({at.x(), at.y(), at.z(), path.feed_mm_s.at(i), bead.width_mm, bead.height_mm});
      }
    return text;
  };
}

/// The squares of the lowest and of the highest layer, and how many layers there are.
std::string squaresOfATrial(const SettingTexts& set) {
  const Toolpath toolpath = flowTrialToolpath(settingsWith<FlowTrialSettings>(set));
  std::string text = std::to_string(toolpath.layers.size()) + "\n";
  for (const Path& path : toolpath.layers.front().paths)
    for (const Point3& at : path.points)
      text += numbersText({at.x(), at.y(), at.z(), path.feed_mm_s.at(0), path.bead.at(0).width_mm});
  return text;
}

/// How well the flow is known by walls whose readings do not scatter.
std::string spreadOfAFlow(const SettingTexts& set) {
  const FlowTrialSettings settings = settingsWith<FlowTrialSettings>(set);
  std::vector<FlowReading> readings;
  for (const double multiplier : flowMultipliers({})) readings.push_back({multiplier, 0.08 * multiplier});
  return numbersText({fitFlow(readings, settings).factor_spread});
}

/// The time offset of a sensor whose stamps are 80 ms late.
std::string timeOfALateSensor(const SettingTexts& set) {
  RecordedCell cell;
  cell.offset_s = 0.08;
  const SensorRecording recording = record(cell, bobbing({}));
  return numbersText(
      {findTime(recording, "bobbing", nominalSensor(), settingsWith<CalibrationSettings>(set), "")
           .time.offset_s});
}

/// The place of a sensor, by a head that nods and sways over a level bed, and what of it is not found.
std::string placeOverABed(const SettingTexts& set) {
  RecordedCell cell;
  cell.noise_mm = 0.01;
  cell.profile_s = 0.04;
  const auto rocking = [](double time_s) {
    const Eigen::AngleAxisd nod(0.25 * std::sin(1.3 * time_s), Point3::UnitX());
    const Eigen::AngleAxisd sway(0.25 * std::sin(0.9 * time_s + 1.0), Point3::UnitY());
    return Eigen::Isometry3d(nozzleAt({100.0, 100.0, 12.0 + 6.0 * std::sin(0.4 * time_s)}) * nod * sway);
  };
  const FoundPose found = findPose({{PlaneTarget{true}, record(cell, rocking, 20.0)}}, nominalSensor(), 0.0,
                                   settingsWith<CalibrationSettings>(set), {"bed", ""});
  return "not found: " + found.pose.not_found + "\n" + numbersText(found.pose.spread);
}

/// The dead time of a feeder that comes 0.6 s late at 10 mm/s, by a scan of its beads.
std::string deadTimeOfAFeeder(const SettingTexts& set) {
  const FeederSteps steps = feederSteps({});
  RecordedCell cell;
  cell.points = 281;
  cell.profile_s = 0.02;
  cell.surface = [&](const Point2& at) {
    for (const CalibrationBead& bead : steps.beads) {
      const double length = (bead.end - bead.start).norm();
      const double place = (at - bead.start).dot(bead.end - bead.start) / length;
      const double aside = std::abs(at.x() - bead.start.x()) / 0.5;
      if (aside >= 1.0 || place < 0.0 || place >= length) continue;
      const double share = std::max(0.0, place - 6.0) / length;
      const auto piece = static_cast<std::size_t>(share * static_cast<double>(steps.amount.size()));
      return 0.4 * steps.amount[piece] * (1.0 - aside * aside);
    }
    return 0.0;
  };
  const LinearMotion motion({75.0, 20.0, 2.0}, {{{75.0, 180.0, 2.0}, 20.0}});
  return numbersText(
      {findFeeder(record(cell, motion), nominalSensor(), 0.0, settingsWith<CalibrationSettings>(set), "")
           .feeder.dead_time_s});
}

}  // namespace

std::vector<SettingProbe> calibrationProbes() {
  return {{"bobbing over a free place",
           "",
           motionsOf(bobbingToolpath),
           {{"calibrate.x_mm=120"},
            {"calibrate.y_mm=120"},
            {"calibrate.bob_mm=3"},
            {"calibrate.bob_low_hz=1"},
            {"calibrate.bob_high_hz=3"},
            {"calibrate.bob_s=20"},
            {"calibrate.clearance_mm=4"}}},
          {"passes over the edges of a patch",
           "",
           motionsOf(edgeToolpath),
           {{"calibrate.passes=8"},
            {"calibrate.scan_mm_s=30"},
            {"calibrate.search_s=1"},
            {"calibrate.bead_width_mm=1"},
            {"calibrate.bead_height_mm=0.4"},
            {"calibrate.bead_mm_s=30"}}},
          {"a cross in a square, scanned twice",
           "",
           motionsOf(crossToolpath),
           {{"calibrate.lift_mm=0"}, {"calibrate.swath_mm=14"}, {"calibrate.square_mm=50"}}},
          {"beads whose amount is stepped",
           "",
           motionsOf(feederToolpath),
           {{"calibrate.step=0.3"},
            {"calibrate.step_mm=20"},
            {"calibrate.feeder_mm_s=5"},
            {"calibrate.feeder_gap_mm=15"}}},
          {"squares of stated multipliers",
           "",
           squaresOfATrial,
           {{"flow_trial.x_mm=120"},
            {"flow_trial.y_mm=120"},
            {"flow_trial.squares=5"},
            {"flow_trial.span=0.1"},
            {"flow_trial.side_mm=20"},
            {"flow_trial.gap_mm=5"},
            {"flow_trial.height_mm=4"},
            {"flow_trial.width_mm=0.5"},
            {"flow_trial.layer_mm=0.25"},
            {"flow_trial.feed_mm_s=20"}}},
          {"the flow by walls", "", spreadOfAFlow, {{"flow_trial.reading_mm=0.05"}}},
          {"the time offset of a late sensor", "", timeOfALateSensor, {{"calibrate.search_s=0.05"}}},
          {"the place of a sensor over a bed",
           "",
           placeOverABed,
           {{"calibrate.max_sigma_mm=0.000001"},
            {"calibrate.max_sigma_deg=0.000001"},
            {"calibrate.noise_mm=0.5"}}},
          {"the dead time of a feeder", "", deadTimeOfAFeeder, {{"calibrate.feeder_mm_s=20"}}}};
}

}  // namespace lamina::test
