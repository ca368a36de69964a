// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/timed_path.hpp"

#include "lamina/base/error.hpp"
#include "trajectory/motion_sample.hpp"
#include "trajectory/timed_motion.hpp"

namespace lamina {
namespace {

// The average of what changes between full acceleration either way changes at most twice as fast as what
// builds up from none.
double averagingTime(const TrajectorySettings& settings) { return 2.0 * settings.jerk_ramp_s; }

Waits waitsOf(const TimingSettings& settings) {
  return {settings.process.settling_s, settings.process.wait_before_s, settings.process.wait_after_s,
          averagingTime(settings.trajectory)};
}

std::shared_ptr<const TimedMotion> timedMotion(const Toolpath& toolpath, const JointPath& path,
                                               const KinematicModel& model, const TimingSettings& settings) {
  validate(settings);
  const JointStations stations = jointStations(toolpath, path, model, settings.motion);
  if (stations.each.size() < 2)
    throw InvalidInput("the joint path of '" + toolpath.part_name + "' has no motion to time");
  return std::make_shared<const TimedMotion>(keptOnLines(stations, model, settings.trajectory), model,
                                             settings);
}

std::vector<double> stationTimes(const TimedMotion& motion) {
  const Timeline& timeline = motion.plan().timeline();
  const JointCurve& curve = motion.curve();
  std::vector<double> reached(curve.spanCount() + 1, 0.0);
  for (std::size_t i = 0; i < timeline.phases().size(); ++i)
    if (timeline.phases()[i].kind == PhaseKind::Move)
      reached[timeline.phases()[i].span + 1] = timeline.endOf(i);
  for (std::size_t i = 1; i < reached.size(); ++i)
    reached[i] += (curve.isRest(i) ? 1.0 : 0.5) * motion.averaging();
  std::vector<double> times;
  times.reserve(curve.ofPath().size());
  for (const std::size_t station : curve.ofPath()) times.push_back(reached[station]);
  return times;
}

}  // namespace

void validate(const TimingSettings& settings) {
  TimingSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked.motion);
  describe(schema, checked.trajectory);
  describe(schema, checked.process);
  schema.validate();
}

TimedMotion::TimedMotion(JointStations stations, const KinematicModel& model, const TimingSettings& settings)
    : settings_(settings),
      curve_(std::move(stations), model, settings.trajectory),
      plan_(curve_, waitsOf(settings)),
      schedule_(plan_.timeline(), averaging(), settings.process, ProcessSchedule::Beads::Whole) {}

std::unique_ptr<const SpeedPlan> TimedMotion::planAt(double feed_share) const {
  return std::make_unique<const SpeedPlan>(curve_, waitsOf(settings_), feed_share);
}

double TimedMotion::averaging() const { return averagingTime(settings_.trajectory); }

TimedPath::TimedPath(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                     const TimingSettings& settings)
    : TimedPath(timedMotion(toolpath, path, model, settings)) {}

TimedPath::TimedPath(std::shared_ptr<const TimedMotion> motion)
    : motion_(std::move(motion)),
      station_times_(lamina::stationTimes(*motion_)),
      events_(motion_->schedule().events()) {}

double TimedPath::duration() const { return motion_->plan().timeline().end() + motion_->averaging(); }

const std::vector<WaypointIndex>& TimedPath::looseTravels() const { return motion_->curve().looseTravels(); }

JointState TimedPath::at(double time_s) const {
  JointState state = motionSample(motion_->plan().timeline(), motion_->averaging(), time_s);
  state.process = motion_->schedule().signalsAt(time_s, state.process);
  return state;
}

ToolpathTime trajectoryTime(const JointTrajectory& trajectory, const JointPath& path, std::size_t layers) {
  ToolpathTime time;
  time.total_s = trajectory.duration();
  const std::vector<double>& stations = trajectory.stationTimes();
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (time.layer_start_s.size() <= path.at[i].layer)
      time.layer_start_s.resize(path.at[i].layer + 1, stations[i]);
  time.layer_start_s.resize(layers, time.total_s);
  return time;
}

ToolpathTime estimateJointTime(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                               const TimingSettings& settings) {
  return trajectoryTime(TimedPath(toolpath, path, model, settings), path, toolpath.layers.size());
}

}  // namespace lamina
