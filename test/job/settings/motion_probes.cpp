// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Motion in time: trajectories, the process in step, hand-over, controllers, approaches and followers.
#include "job/settings/setting_probe.hpp"
#include "lamina/base/manual_clock.hpp"
#include "lamina/deposition/path_follower.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/trajectory/approach.hpp"
#include "lamina/trajectory/simulated_controller.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina::test {
namespace {

std::vector<double> numbersOf(const JointValues& values) {
  return {values.data(), values.data() + values.size()};
}

/// Two beads round a corner each, with turns of the nozzle, and a travel between them.
Toolpath corners() {
  Path bead = straightPath({0, 0, 0.2}, {30, 0, 0.2});
  bead.points.emplace_back(30, 30, 0.2);
  const Eigen::Quaterniond turned = Eigen::AngleAxisd(0.2, Point3::UnitX()) * nozzleDown();
  bead.orientation =
      AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{nozzleDown(), nozzleDown(), turned});
  Path next = straightPath({0, 60, 0.2}, {30, 60, 0.2});
  next.orientation = AlongPath<Eigen::Quaterniond>(turned);
  Path travel = straightPath(bead.lastPoint(), next.firstPoint());
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.feed_mm_s = 100.0;
  travel.orientation = AlongPath<Eigen::Quaterniond>(turned);
  return {"corners", {{0.2, 0.2, {bead, travel, next}}}};
}

std::string trajectoryText(const SettingTexts& set) {
  const RunSettings settings = settingsWith<RunSettings>(set);
  const auto model = kinematicModelByName("five_axis_head_ac");
  NoProgress nobody;
  KinematicModelRun run =
      runOn(*model, corners(), Eigen::Isometry3d(Eigen::Translation3d(60, 60, 0)), settings.joints, nobody);
  const TimedRun timed = inTime(std::move(run), *model, settings.timing);
  std::string text =
      numbersText({timed.trajectory->duration()}) + numbersText(timed.trajectory->stationTimes());
  for (const ProcessEvent& event : timed.trajectory->events())
    text += toString(event.channel) + numbersText({event.time_s, event.is_on ? 1.0 : 0.0});
  return text;
}

std::string estimatedTime(const SettingTexts& set) {
  return numbersText({estimateTime(twoLayers(), settingsWith<RunSettings>(set).timing.motion).total_s});
}

SettingProbe trajectoryProbe() {
  return {"a trajectory",
          "",
          trajectoryText,
          {{"motion.acceleration_mm_s2=300"},
           {"motion.travel_acceleration_mm_s2=500"},
           {"trajectory.blend_tolerance_mm=0.5"},
           {"trajectory.blend_tolerance_deg=0"},
           {"trajectory.joint_ramp_s=0.6"},
           {"trajectory.jerk_ramp_s=0.1"},
           {"process.kind=powder"},
           {"process.laser_on_lead_s=0.1", "process.kind=powder"},
           {"process.laser_off_lead_s=0.1", "process.kind=powder"},
           {"process.wire_on_lead_s=0.1", "process.kind=wire"},
           {"process.wire_off_lead_s=0.1", "process.kind=wire"},
           {"process.settling_s=2", "process.kind=powder"},
           {"process.wait_before_s=0.5"},
           {"process.wait_after_s=0.5"}}};
}

SettingProbe lineToleranceProbe() {
  return {"lines of a trajectory",
          "joints.tip_tolerance_mm=100;joints.tool_axis_tolerance_deg=90;joints.max_step_mm=1000;"
          "joints.max_step_deg=180",
          trajectoryText,
          {{"trajectory.line_tolerance_mm=1"}, {"trajectory.line_tolerance_deg=0.001"}}};
}

/// What a feeder hands over that is made as fast as it may be and lays half from 0.25 s on, until it is
/// aborted at 0.5 s.
std::string handedOver(const SettingTexts& set) {
  const TiltingGantry gantry;
  const Toolpath toolpath = twoLayers();
  const TimedPath timed(toolpath, uprightPath(toolpath, gantry), gantry, {});
  const auto settings = settingsWith<TrajectoryFeederSettings>(set);
  TrajectoryFeeder feeder(timed, settings);
  std::string text;
  for (double now_s = 0.0; now_s < 1.0; now_s += 0.125) {
    if (now_s == 0.25) feeder.setSpeed(settings.feed_most, now_s);
    if (now_s == 0.25) feeder.setShare(OverrideKind::Flow, 0.5, now_s);
    if (now_s == 0.5) feeder.abort(now_s);
    while (const auto chunk = feeder.next(now_s))
      text += numbersText({now_s, double(chunk->points.size()), chunk->points.front().time_s,
                           chunk->points.back().time_s, chunk->points.back().process.flow_mm3_s});
  }
  return text + numbersText({feeder.restTime()});
}

/// Where a controller has its joints while it is fed for half a second, and while it then starves.
std::string servoed(const SettingTexts& set) {
  const TiltingGantry gantry;
  const Toolpath toolpath = twoLayers();
  const TimedPath timed(toolpath, uprightPath(toolpath, gantry), gantry, {});
  TrajectoryFeeder feeder(timed, {});
  ManualClock clock;
  SimulatedController controller(clock, gantry, settingsWith<ServoSettings>(set), timed.at(0.0).position);
  std::string text;
  for (double now_s = 0.0; now_s < 2.0; now_s += 0.05) {
    if (now_s < 0.1)
      while (const auto chunk = feeder.next(now_s)) controller.accept(*chunk);
    clock.moveTo(now_s + 0.05);
    controller.advance();
    text += numbersText(numbersOf(controller.position()));
  }
  return text + numbersText({double(controller.report().cycles)});
}

/// Places on two layers of a nozzle that is beside the path, and then jumps ahead.
std::string followed(const SettingTexts& set) {
  const Toolpath toolpath = twoLayers();
  PathFollower follower(toolpath, settingsWith<FollowingSettings>(set));
  std::string text;
  const auto observe = [&](const Point3& tip) {
    const PathPosition place = follower.observe(tip);
    text += numbersText({double(place.path), double(place.motion), place.fraction});
  };
  for (double x = 0.5; x < 5.0; x += 0.5) observe({x, 0.3, 0.2});
  for (double y = 0.5; y < 9.5; y += 0.25) observe({10, y, 0.2});
  return text;
}

}  // namespace

std::vector<SettingProbe> motionProbes() {
  return {
      trajectoryProbe(),
      lineToleranceProbe(),
      {"an estimate of time", "", estimatedTime, {{"motion.junction_deviation_mm=0.2"}}},
      {"hand-over",
       "",
       handedOver,
       {{"feeder.rate_hz=100"},
        {"feeder.points=20"},
        {"feeder.ahead_s=1"},
        {"feeder.reaction_s=0.2"},
        {"feeder.feed_most=2"},
        {"feeder.override_ramp_s=0"}}},
      {"a simulated controller",
       "",
       servoed,
       {{"servo.rate_hz=100"}, {"servo.lag_s=0.05"}, {"servo.damping=0.7"}, {"servo.brake_s=0.8"}}},
      {"a follower of paths", "", followed, {{"following.tolerance_mm=0.5"}, {"following.look_ahead_mm=2"}}}};
}

}  // namespace lamina::test
