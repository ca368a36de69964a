// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Toolpaths that are driven, and what is run dry.
#include "lamina/base/error.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"
#include "nodes/gcode_streamer/streamer_settings.hpp"
#include "nodes/trajectory_driver/drive_job.hpp"
#include "nodes/trajectory_driver/driver_settings.hpp"
#include "nodes/trajectory_driver/process_io_watch.hpp"
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

/// Where a job is resumed whose nozzle stands a little beside its toolpath.
std::string resumedAt(const SettingTexts& set) {
  Eigen::Isometry3d nozzle = Eigen::Isometry3d::Identity();
  nozzle.translation() = Point3(10.3, 7, 0.2);
  nozzle.linear() = nozzleDown().toRotationMatrix();
  ReportedProgress reported;
  reported.laid_mm = 12.0;
  return toText(
      resumePlace(LaidBeads(twoLayers()), reported, nozzle, settingsWith<DriverSettings>(set).resume));
}

/// When a driver gives up a controller of which it hears nothing.
std::string givenUp(const SettingTexts& set) {
  const ros::Time begin(1000.0);
  const auto settings = settingsWith<DriverSettings>(set);
  ReportWatch watch(settings.tracking, settings.controller_wait_s, begin);
  watch.hear(begin, begin);
  int looks = 0;
  while (looks < 10000 && !watch.look(begin + ros::Duration(0.01 * looks))) ++looks;
  return std::to_string(looks);
}

/// Whether a bead is driven on which the head leans into the bed.
std::string drivenIntoTheBed(const SettingTexts& set) {
  const auto settings = settingsWith<DriverSettings>(set);
  const auto model = kinematicModelOf(settings.machine);
  Toolpath toolpath = twoLayers();
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths)
      path.orientation =
          AlongPath<Eigen::Quaterniond>(Eigen::AngleAxisd(-0.9, Point3::UnitY()) * nozzleDown());
  MachineToolpath placed;
  placed.machine = model->name();
  placed.bed_from_part = Eigen::Translation3d(0, 0, 0);
  placed.toolpath = toolpath;
  NoProgress nobody;
  try {
    driveJob(
        placed, *model, settings, [](const MachineCheck&) {}, nobody);
    return "driven";
  } catch (const Unreachable& error) {
    return error.what();
  }
}

/// What a driver says of process_io half a second after it said that it is ready, and each half after that.
std::string processSilentFor(const SettingTexts& set) {
  const ProcessIoDemand demand = settingsWith<DriverSettings>(set).process_io;
  lamina_msgs::ProcessReady ready;
  ready.ready = true;
  std::string text = processFault(demand, ready, ros::Time(), ros::Time(1000.0)) + "\n";
  for (int i = 1; i <= 8; ++i)
    text +=
        processFault(demand, ready, ros::Time(1000.0), ros::Time(1000.0 + 0.5 * i)).empty() ? "." : "silent ";
  return text;
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
          {"a job that is resumed", "", resumedAt, {{"resume.overlap_mm=3"}, {"resume.tolerance_mm=0.2"}}},
          {"a tip off its path", "", off, {{"tracking.tip_mm=8"}}},
          {"a controller that is silent",
           "",
           givenUp,
           {{"tracking.silence_s=0.5"},
            {"tracking.silence_by=stamps"},
            {"controller_wait_s=20", "tracking.silence_by=stamps"}}},
          {"a head in the bed",
           "machine.name=five_axis_head_table",
           drivenIntoTheBed,
           {{"check_clearance=false"}}},
          {"process_io that says that it is ready, and then no more",
           "process_io.required=true",
           processSilentFor,
           {{"process_io.required=false"}, {"process_io.silence_s=3"}}}};
}

}  // namespace lamina::test
