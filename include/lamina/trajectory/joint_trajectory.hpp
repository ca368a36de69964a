// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/process_signals.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {

/// The joints at one instant.
struct JointState {
  double time_s = 0.0;
  JointValues position;      ///< [mm, rad]
  JointValues velocity;      ///< [mm/s, rad/s]
  JointValues acceleration;  ///< [mm/s², rad/s²]
  double tip_speed_mm_s = 0.0;
  ProcessSignals process;
  WaypointIndex heading_for;  ///< waypoint at which the running motion ends
};

/// Interface of the joints' motion over time, the result of time-parametrisation, from which controllers are
/// fed.
class JointTrajectory {
 public:
  virtual ~JointTrajectory() = default;
  virtual double duration() const = 0;  ///< [s]
  /// The state at a time, which is clamped to [0, duration]; may be called for times in any order.
  virtual JointState at(double time_s) const = 0;
  /// The times at which the stations of the joint path are passed [s], one per station.
  virtual const std::vector<double>& stationTimes() const = 0;
};

}  // namespace lamina
