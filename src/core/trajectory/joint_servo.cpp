// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/joint_servo.hpp"

#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr int kSubsteps = 8;  // of a step, of a lag of second order

}  // namespace

JointServo::JointServo(double lag_s, double damping, JointValues start)
    : lag_s_(lag_s),
      damping_(damping),
      position_(std::move(start)),
      velocity_(JointValues::Zero(position_.size())) {}

void JointServo::follow(const JointValues& asked, double step_s) {
  if (lag_s_ <= 0.0 || damping_ <= 0.0) {
    const double part = lag_s_ > 0.0 ? 1.0 - std::exp(-step_s / lag_s_) : 1.0;
    const JointValues next = position_ + part * (asked - position_);
    velocity_ = (next - position_) / step_s;
    position_ = next;
    return;
  }
  const double natural = 1.0 / lag_s_;
  const auto substeps = kSubsteps * static_cast<int>(std::ceil(step_s * natural * damping_ + 1.0));
  const double h = step_s / substeps;
  for (int i = 0; i < substeps; ++i) {
    // Implicit in the damping: stable whatever the step.
    velocity_ =
        (velocity_ + h * natural * natural * (asked - position_)) / (1.0 + 2.0 * damping_ * natural * h);
    position_ += h * velocity_;
  }
}

}  // namespace lamina
