// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_follower.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/trajectory/joint_cubic.hpp"

namespace lamina {
namespace {

// As in the program on the robot.
constexpr double kPull = 0.005;       // of its own count towards that of the targets, per cycle
constexpr double kWidestPhase = 5.0;  // cycles that it may be off

struct PlannedPoint {
  double time_s;
  const JointValues& position;
  const JointValues& velocity;
};

}  // namespace

ServojFollower::ServojFollower(const ServojSettings& settings, double lag_s, const JointValues& start)
    : settings_(settings),
      silent_cycles_(std::round(settings.silence_s / settings.cycle())),
      servo_(lag_s, 0.0, start),
      position_(start),
      velocity_(JointValues::Zero(start.size())) {}

void ServojFollower::hear(const CyclicTarget& target) { newest_ = target; }

void ServojFollower::end() {
  if (state_ != ServojState::Silent) state_ = ServojState::Ended;
}

bool ServojFollower::isAtRest() const { return velocity_.cwiseAbs().maxCoeff() < 1e-6; }

void ServojFollower::cycle() {
  if (state_ == ServojState::Silent || state_ == ServojState::Ended) return stopOn();
  if (newest_.cycle == 0) return;
  state_ = ServojState::Following;
  ++following_.cycles;
  silent_ = newest_.cycle == last_ ? silent_ + 1.0 : 0.0;
  if (silent_ > silent_cycles_) {
    state_ = ServojState::Silent;
    return stopOn();
  }
  if (silent_ > 0.0) ++following_.bridged;
  lead();
}

void ServojFollower::lead() {
  const auto count = static_cast<double>(newest_.cycle);
  phase_ = last_ == 0 ? count : phase_ + 1.0;
  // Without a new target there is nothing to go by.
  if (silent_ == 0.0) phase_ += kPull * (count - phase_);
  if (std::abs(count - phase_) > kWidestPhase + silent_) phase_ = count;
  last_ = newest_.cycle;
  const double ahead_s = settings_.ahead();
  const double since_s = (phase_ - count) * settings_.cycle();
  if (since_s > ahead_s) ++following_.without;
  const PlannedPoint now{0.0, newest_.now.position, newest_.now.velocity};
  const PlannedPoint ahead{ahead_s, newest_.ahead.position, newest_.ahead.velocity};
  servo_.follow(cubicPosition(now, ahead, std::min(since_s, ahead_s)), settings_.cycle());
  position_ = servo_.position();
  velocity_ = servo_.velocity();
}

/// All joints slow down together, the fastest of them by the deceleration of stopj.
void ServojFollower::stopOn() {
  const double fastest = velocity_.cwiseAbs().maxCoeff();
  if (fastest == 0.0) return;
  const double step_s = settings_.cycle();
  const double left = std::max(0.0, fastest - settings_.stop_rad_s2 * step_s);
  const JointValues next = left / fastest * velocity_;
  position_ += 0.5 * step_s * (velocity_ + next);
  velocity_ = next;
}

}  // namespace lamina
