// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "joint_messages.hpp"
#include "playback.hpp"

namespace lamina {
namespace {

class JointPlayback : public Playback {
 public:
  JointPlayback(TimedRun timed, const KinematicModel& model, const MachineTransforms& transforms)
      : timed_(std::move(timed)), model_(model), transforms_(transforms) {}

  const ToolpathTime& time() const override { return timed_.time; }

  double nextWaypointTime() const override {
    const std::vector<double>& passed = timed_.trajectory->stationTimes();
    const auto next = std::upper_bound(passed.begin(), passed.end(), at_s_);
    return next == passed.end() ? std::numeric_limits<double>::infinity() : *next;
  }

  JointPositions at(double time_s) override {
    at_s_ = time_s;
    return transforms_.positions(model_.urdfJoints(jointsAt(time_s)));
  }

  trajectory_msgs::JointTrajectory trajectory(const TimeSpan& span, double step_s) override {
    trajectory_msgs::JointTrajectory message;
    message.joint_names = jointNames(model_);
    for (const double time_s : evenTimes(span.begin_s, span.end_s, step_s)) {
      message.points.push_back(toMessage(timed_.trajectory->at(time_s), model_.joints()));
      message.points.back().time_from_start = ros::Duration(time_s - span.begin_s);
    }
    return message;
  }

  std::vector<NozzleState> nozzle(const TimeSpan& span, double step_s) override {
    return nozzleStates(evenTimes(span.begin_s, span.end_s, step_s),
                        [this](double time_s) { return nozzleState(timed_.trajectory->at(time_s), model_); });
  }

 private:
  /// At the time of a waypoint those of the waypoint: the motion may round it within its tolerance.
  JointValues jointsAt(double time_s) const {
    const std::vector<double>& passed = timed_.trajectory->stationTimes();
    const auto station = std::lower_bound(passed.begin(), passed.end(), time_s);
    const bool is_waypoint = station != passed.end() && *station == time_s;
    return is_waypoint ? timed_.run.path.values[static_cast<std::size_t>(station - passed.begin())]
                       : timed_.trajectory->at(time_s).position;
  }

  TimedRun timed_;
  const KinematicModel& model_;
  const MachineTransforms& transforms_;
  double at_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::unique_ptr<Playback> jointPlayback(TimedRun timed, const KinematicModel& model,
                                        const MachineTransforms& transforms) {
  return std::make_unique<JointPlayback>(std::move(timed), model, transforms);
}

}  // namespace lamina
