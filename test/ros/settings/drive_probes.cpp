// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Toolpaths that are driven, and what is run dry.
#include "lamina/base/error.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"
#include "nodes/gcode_streamer/streamer_settings.hpp"
#include "nodes/trajectory_driver/driver_settings.hpp"
#include "nodes/trajectory_driver/report_watch.hpp"
#include "nodes/trajectory_driver/tracking.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/gantry_head.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina::test {
namespace {

/// A program of G-code as it is run dry.
std::string dryProgram(const SettingTexts& set) {
  DryRun run(settingsWith<GcodeStreamerSettings>(set).dry);
  std::string dry;
  try {
    for (const char* line : {"G1 X10 E1 A2 F1200", "START_PRINT", "G1 X20"})
      dry += run.line(line).value_or("") + "\n";
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return dry;
}

/// A toolpath as it is driven dry.
std::string dryToolpath(DryPlace place, const SettingTexts& set) {
  return toolpathId(drivenAs({place, 1.0}, twoLayers(), settingsWith<DriverSettings>(set).dry));
}

/// Where a motion rests that is aborted on its way, and when.
std::string aborted(const SettingTexts& set) {
  const TiltingGantry gantry;
  const Toolpath toolpath = twoLayers();
  const TimedPath timed(toolpath, uprightPath(toolpath, gantry), gantry, {});
  const auto settings = settingsWith<DriverSettings>(set);
  TrajectoryFeeder feeder(timed, settings.feeder);
  while (feeder.next(0.0)) {
  }
  feeder.abort(0.5, {settings.lift_mm, settings.lift_mm_s}, gantry);
  const JointValues rest = feeder.at(feeder.restTime()).position;
  return numbersText({feeder.restTime(), rest[2]});
}

/// What a driver says of a tip that is 7 mm off.
std::string off(const SettingTexts& set) {
  const GantryHead gantry(ToolAxisSpin::Free);
  Tracking tracking(gantry);
  JointValues actual = JointValues::Zero(5);
  actual.head<3>() << 2.0, 3.0, 6.0;
  tracking.add(JointValues::Zero(5), actual);
  return tracking.deviation(settingsWith<DriverSettings>(set).tracking.tip_mm).value_or("near enough");
}

/// When a driver gives up a controller of which it hears nothing.
std::string givenUp(const SettingTexts& set) {
  const ros::Time begin(1000.0);
  ReportWatch watch(settingsWith<DriverSettings>(set).tracking, 5.0, begin);
  watch.hear(begin, begin);
  int looks = 0;
  while (looks < 1000 && !watch.look(begin + ros::Duration(0.01 * looks))) ++looks;
  return std::to_string(looks);
}

}  // namespace

std::vector<SettingProbe> driveProbes() {
  const auto lifted = [](const SettingTexts& set) { return dryToolpath(DryPlace::Lift, set); };
  const auto pointed = [](const SettingTexts& set) { return dryToolpath(DryPlace::Point, set); };
  return {{"a program that is run dry",
           "",
           dryProgram,
           {{"dry.speed=0.5"}, {"dry.extrusion=EA"}, {"dry.unknown=refuse"}}},
          {"a toolpath that is run dry above it", "", lifted, {{"dry.lift_mm=30"}}},
          {"a toolpath that is run dry by a pointer",
           "dry.pointer_mm=0,0,40",
           pointed,
           {{"dry.pointer_mm=0,5,40"}}},
          {"a motion that is aborted", "", aborted, {{"lift_mm=20"}, {"lift_mm_s=5"}}},
          {"a tip off its path", "", off, {{"tracking.tip_mm=8"}}},
          {"a controller that is silent",
           "",
           givenUp,
           {{"tracking.silence_s=0.5"}, {"tracking.silence_by=stamps"}}}};
}

}  // namespace lamina::test
