// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joints that lag behind what they are asked.
class JointServo {
 public:
  /// @param lag_s    time constant of each joint; 0 follows at once
  /// @param damping  0 for a lag of first order; else that of one of second order
  JointServo(double lag_s, double damping, JointValues start);

  /// Goes on by a step, towards where the joints are asked to be at its end.
  /// @param step_s  greater than 0
  void follow(const JointValues& asked, double step_s);
  /// Stops dead.
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
