// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The closed loop on heights, and the process that it is tried on.
#include "job/settings/setting_probe.hpp"
#include "lamina/control/metal_split.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/control/stability.hpp"
#include "lamina/control/trailing_trim.hpp"
#include "lamina/deposition/grown_deposit.hpp"
#include "support/control_layers.hpp"
#include "support/measured_layers.hpp"
#include "support/printed_wall.hpp"

namespace lamina::test {
namespace {

/// A wall with settings of the loop and of the process.
WallCase wallWith(const SettingTexts& set) {
  WallCase wall;
  SettingsSchema schema;
  describe(schema, wall.loop);
  describe(schema, wall.plant);
  for (const SettingText& setting : set) schema.set(setting.key, setting.text);
  wall.lead = feederOf(wall.loop);
  return wall;
}

/// Errors of a short wall, layer by layer.
std::string walled(const SettingTexts& set) {
  WallCase wall = wallWith(set);
  wall.layers = 8;
  wall.length_mm = 60.0;
  wall.cell_mm = 1.0;
  const PrintedWall printed = printedWall(wall);
  std::vector<double> numbers;
  for (const WallLayer& layer : printed.layers) {
    numbers.push_back(layer.mean_error_mm);
    numbers.push_back(layer.flatness_mm);
  }
  return numbersText(numbers);
}

/// A layer of which half is seen, a millimetre too low.
LayerFigures halfSeen(const LoopSettings& settings) {
  HeightLoop loop(settings);
  loop.beginLayer(straightBeads({0.0}, 40.0, 1.0));
  loop.lay(loop.correction(LoopState::Identifying));
  for (int profile = 0; profile < 3; ++profile) {
    for (std::size_t i = 0; i < 24; ++i) loop.see(i, {1.0, 6, 0.02});
    loop.endCloud();
  }
  return loop.endLayer();
}

std::string supervised(const SettingTexts& set) {
  const auto settings = settingsWith<LoopSettings>(set);
  LoopStatus status;
  status.state = LoopState::Active;
  std::string text;
  const auto note = [&](const LoopStep& step) {
    text += toString(step.status.state);
    for (const RaisedAlarm& alarm : step.alarms)
      text += " " + std::to_string(int(alarm.alarm)) + ":" + std::to_string(int(alarm.reaction));
    text += "\n";
  };
  SensorWatch watch;
  watch.is_scanning = true;
  watch.silent_s = 3.0;
  watch.map_late_s = 3.0;
  note(afterWatch(status, watch, settings));
  const LayerFigures half = halfSeen(settings);
  note(afterLayer(status, half, settings));
  LayerFigures unseen;
  LoopStatus lost = status;
  for (int layer = 0; layer < 3; ++layer) {
    const LoopStep step = afterLayer(lost, unseen, settings);
    lost = step.status;
    note(step);
  }
  LayerFigures limited = half;
  limited.is_measured = true;
  limited.limited_share = 1.0;
  for (int layer = 0; layer < 3; ++layer) {
    const LoopStep step = afterLayer(status, limited, settings);
    status = step.status;
    note(step);
  }
  return text;
}

std::string checked(const SettingTexts& set) {
  LoopCalibration calibration;
  calibration.has_time_offset = calibration.has_sensor_place = true;
  calibration.place_error_mm = 3.0;
  return checkStability(settingsWith<LoopSettings>(set), calibration).reason + " ";
}

std::string splitUp(const SettingTexts& set) {
  const auto settings = settingsWith<LoopSettings>(set);
  const LayerCells cells = straightBeads({0.0}, 4.0, 1.0);
  const MetalCorrection fixed = metalSplit(cells, {0.3, -0.3, 0.1, -0.1}, PowerSource::Fixed, settings);
  const MetalCorrection follows = metalSplit(cells, {0.3, -0.3, 0.1, -0.1}, PowerSource::Follows, settings);
  return numbersText(fixed.speed_mm_s) + numbersText(follows.speed_mm_s);
}

std::string trimmed(const SettingTexts& set) {
  const auto trim = trimOf(settingsWith<LoopSettings>(set), 0.5, 1.0);
  if (!trim) return "none";
  TrailingTrim loop(*trim);
  std::vector<double> numbers;
  for (int i = 0; i < 100; ++i) numbers.push_back(loop.advance(0.1));
  return numbersText(numbers);
}

std::string learnt(const SettingTexts& set) {
  DepositedLayer layer{straightBeads({0.0}, 4.0, 1.0), std::vector<double>(4, 0.0),
                       std::vector<double>(4, 0.2)};
  const PartMap first{{}, 1, {std::vector<double>(layer.cells.size(), 0.0)}};
  return numbersText(
      learntFromPart(first, {}, {layer}, PartEnd::Complete, settingsWith<LoopSettings>(set)).amount[0]);
}

/// What two profiles over a bead say, one with something wrong everywhere, one from the side.
std::string sighted(const SettingTexts& set) {
  const auto settings = settingsWith<SightSettings>(set);
  const MeasuredLayer measured = inclinedLayer(0.0, 1, {3.0, 1.5});
  CellAtlas atlas(settings.window_layers);
  atlas.add(std::make_shared<const LayerCells>(cellsOf(measured)));
  SensorProfile profile;
  profile.toolpath_from_sensor = sensorOver(measured, 0, 0.5);
  for (int i = -14; i <= 14; ++i) profile.points.emplace_back(0.1 * i, 0.0, i < 0 ? 60.0 : 62.0);
  std::vector<double> numbers;
  const auto note = [&] {
    const ProfileReadings read = readProfile(profile, atlas, {}, settings);
    numbers.push_back(double(read.counts.used));
    for (const LayerReading& one : read.readings) numbers.push_back(one.reading.sigma_mm);
  };
  note();
  profile.toolpath_from_sensor.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 1, 0).normalized()));
  profile.toolpath_from_sensor.translation() =
      measured.place(0, 0.5, 0.0, 0.0) - profile.toolpath_from_sensor.linear() * Point3(0, 0, 60);
  note();
  return numbersText(numbers);
}

SettingProbe sightProbe() {
  return {"a bead that is seen",
          "",
          sighted,
          {{"sight.window_layers=1"},
           {"sight.crown_share=0.5"},
           {"sight.sigma_mm=0.05"},
           {"sight.lateral_sigma_mm=0.3"},
           {"sight.pose_sigma_mm=0.05"},
           {"sight.greatest_angle_deg=30"},
           {"sight.least_depth_mm=61", "sight.greatest_depth_mm=65"},
           {"sight.greatest_depth_mm=61"},
           {"sight.trim_points=12"}}};
}

SettingProbe lawProbe() {
  return {"a wall in a closed loop",
          "plant.gain=0.9;plant.end_loss=0.15;plant.wave=0.05;plant.random=0.03",
          walled,
          {{"loop.process=pressed"},
           {"loop.gain=0.7"},
           {"loop.learning=0.5"},
           {"loop.least_amount=-0.02", "plant.gain=1.3"},
           {"loop.greatest_amount=0.05"},
           {"loop.low_pass_mm=6"},
           {"loop.feeder_rate_s=0.01"},
           {"loop.layer_volume=0.02"},
           {"loop.first_layers=0"},
           {"loop.growth_spread=0.02"},
           {"loop.reading_correlation=0.9"},
           {"loop.z=surface", "plant.standoff=0.3"},
           {"loop.dead_time_s=1"},
           {"loop.lag_s=1"}}};
}

SettingProbe plantProbe() {
  return {"a wall of a disturbed process",
          "loop.first_layers=0",
          walled,
          {{"plant.gain=0.8"},
           {"plant.wear=0.2"},
           {"plant.end_loss=0.2"},
           {"plant.end_mm=5", "plant.end_loss=0.2"},
           {"plant.wave=0.1"},
           {"plant.wave_mm=40", "plant.wave=0.1"},
           {"plant.random=0.05"},
           {"plant.random_mm=10", "plant.random=0.05"},
           {"plant.standoff=0.3", "plant.gain=0.9"},
           {"plant.levelling_mm=2", "plant.random=0.05"},
           {"plant.dead_time_s=1", "plant.end_loss=0.2"},
           {"plant.lag_s=1", "plant.end_loss=0.2"},
           {"plant.thermal=0.1"},
           {"plant.cooling_s=20", "plant.thermal=0.1"},
           {"plant.slump_s=5", "plant.thermal=0.1"},
           {"plant.nozzle_offset_mm=5,0,0", "plant.end_loss=0.2"},
           {"plant.z_error_mm=0.3", "plant.standoff=0.3"},
           {"plant.clog=0.5", "plant.clog_at_layer=4"},
           {"plant.clog_at_layer=3", "plant.clog=0.5"},
           {"plant.detach_at_layer=5"},
           {"plant.seed=2", "plant.random=0.05"}}};
}

/// Where a bead lies, of which a fifth is missing.
std::string scanty(const SettingTexts& set) {
  const auto plant = settingsWith<PlantSettings>(set);
  GrownDeposit deposit(HeightMap(heightGrid({Point2(0, 0), Point2(20, 10)}, 0.25), 0.0), plant, {3.0});
  deposit.lay({{5, 5, 1.5}, {15, 5, 1.5}, 36.0, 0.0, 1.0});
  deposit.endBead();
  return numbersText({deposit.surface().nearest({10.1, 5.1}), deposit.surface().nearest({10.1, 6.4})});
}

}  // namespace

std::vector<SettingProbe> loopProbes() {
  return {lawProbe(),
          plantProbe(),
          {"a bead with too little material", "", scanty, {{"plant.pressed=true"}}},
          sightProbe(),
          {"a loop that is supervised",
           "",
           supervised,
           {{"loop.min_coverage=0.7"},
            {"loop.replan=scale"},
            {"loop.on_loss=open"},
            {"loop.silence_s=5"},
            {"loop.wait_s=5"},
            {"loop.alarm_layers=0.3"}}},
          {"a loop that is checked", "", checked, {{"loop.narrow_low_pass=raised"}}},
          {"wire, arc and speed",
           "loop.speed_exponent=-0.4",
           splitUp,
           {{"loop.speed_exponent=-0.6"},
            {"loop.least_speed_mm_s=8"},
            {"loop.greatest_speed_mm_s=12"},
            {"loop.heat=0.05"}}},
          {"a trim behind the nozzle",
           "loop.trim=0.18;loop.sensor_behind_mm=25",
           trimmed,
           {{"loop.trim=0.1"}, {"loop.sensor_behind_mm=40"}, {"loop.trim_lead_mm=10"}}},
          {"a part learnt from", "", learnt, {{"loop.part_learning=0.8"}}}};
}

}  // namespace lamina::test
