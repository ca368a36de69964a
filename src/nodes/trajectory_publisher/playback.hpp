// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <trajectory_msgs/JointTrajectory.h>

#include <memory>
#include <vector>

#include "conversions.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/trajectory/nozzle_motion.hpp"
#include "tf/machine_transforms.hpp"

namespace lamina {

/// Seconds of a toolpath, from its start.
struct TimeSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// A toolpath as a machine runs it, in time.
class Playback {
 public:
  virtual ~Playback() = default;

  virtual const ToolpathTime& time() const = 0;
  /// Of all joints that move [m, rad]; before 0 at the start, after the end at the end.
  virtual JointPositions at(double time_s) = 0;
  /// When the motion that runs at the time asked for last ends, which is at a waypoint; infinite after the
  /// end, and before `at` is called.
  virtual double nextWaypointTime() const = 0;
  /// The driven joints over a span of time, from its begin, at even steps and at its end. Header without
  /// stamp.
  virtual trajectory_msgs::JointTrajectory trajectory(const TimeSpan& span, double step_s) = 0;
  /// The nozzle over a span of time in the same way, from the same motion.
  virtual std::vector<NozzleState> nozzle(const TimeSpan& span, double step_s) = 0;
};

/// Of a machine of linear axes: planned only as far ahead as braking needs.
/// @param placed  must outlive the playback
std::unique_ptr<Playback> linearPlayback(const MachineToolpath& placed, const CartesianMachine& machine,
                                         const MotionLimits& limits);

/// Of a machine or robot of any joints.
/// @param model       must outlive the playback
/// @param transforms  of the same; must outlive the playback
std::unique_ptr<Playback> jointPlayback(TimedRun timed, const KinematicModel& model,
                                        const MachineTransforms& transforms);

}  // namespace lamina
