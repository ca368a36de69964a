// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Simulated joints that lag behind their commanded positions.
class JointServo {
 public:
  /// @param lag_s    time constant of each joint; 0 for joints that follow at once
  /// @param damping  0 for a lag of first order; else the damping ratio of a lag of second order
  JointServo(double lag_s, double damping, JointValues start);

  /// Advances by a time step.
  /// @param asked   positions commanded for the end of the step
  /// @param step_s  greater than 0
  void follow(const JointValues& asked, double step_s);
  /// Sets all velocities to 0 at once.
  void stop() { velocity_.setZero(); }

  const JointValues& position() const { return position_; }
  const JointValues& velocity() const { return velocity_; }

 private:
  double lag_s_;
  double damping_;
  JointValues position_;
  JointValues velocity_;
};

}  // namespace lamina
