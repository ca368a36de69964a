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
  /// Positions of all moving joints at a time [m, rad]; those of the start before 0, those of the end after
  /// the end.
  virtual JointPositions at(double time_s) = 0;
  /// Time at which the motion that runs at the last requested time ends, at a waypoint; infinite after the
  /// end, and before `at` is called.
  virtual double nextWaypointTime() const = 0;
  /// The driven joints over a span of time: at even steps from its beginning, and at its end. The header has
  /// no stamp.
  virtual trajectory_msgs::JointTrajectory trajectory(const TimeSpan& span, double step_s) = 0;
  /// The nozzle over a span of time in the same way, from the same motion.
  virtual std::vector<NozzleState> nozzle(const TimeSpan& span, double step_s) = 0;
};

/// Playback on a machine with linear axes: planned only as far ahead as braking needs.
/// @param placed  must outlive the playback
std::unique_ptr<Playback> linearPlayback(const MachineToolpath& placed, const CartesianMachine& machine,
                                         const MotionLimits& limits);

/// Playback on a machine or robot with any joints.
/// @param model       must outlive the playback
/// @param transforms of that model; must outlive the playback
std::unique_ptr<Playback> jointPlayback(TimedRun timed, const KinematicModel& model,
                                        const MachineTransforms& transforms);

}  // namespace lamina
