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
  WaypointIndex heading_for;  ///< the waypoint at which the running motion ends
};

/// Joints over time that can be asked in any order; what time-parametrisation makes and controllers are fed.
class JointTrajectory {
 public:
  virtual ~JointTrajectory() = default;
  virtual double duration() const = 0;  ///< [s]
  /// Before 0 at the start, after the duration at the end.
  virtual JointState at(double time_s) const = 0;
  /// When each station of the joint path is passed [s].
  virtual const std::vector<double>& stationTimes() const = 0;
};

}  // namespace lamina
