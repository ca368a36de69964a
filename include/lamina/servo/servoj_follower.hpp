// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "lamina/servo/servoj_frames.hpp"
#include "lamina/servo/servoj_settings.hpp"
#include "lamina/trajectory/joint_servo.hpp"

namespace lamina {

/// How well a robot was led.
struct ServojFollowing {
  std::size_t cycles = 0;   ///< since the first target
  std::size_t bridged = 0;  ///< of them without a new target, on the way that was planned
  std::size_t without = 0;  ///< of them with no target at all: beyond what was planned
};

/// A robot that is not there, with what `servojProgram` does on it: follows targets cycle by cycle, with
/// joints that lag behind, and brakes by itself after a silence. Deterministic; takes no memory from the
/// heap.
class ServojFollower {
 public:
  /// @param lag_s  time constant of the joints
  ServojFollower(const ServojSettings& settings, double lag_s, const JointValues& start);

  /// Takes a target; it replaces the one before.
  void hear(const CyclicTarget& target);
  /// Brakes for good.
  void end();
  void cycle();

  ServojReport report() const { return {state_, newest_.cycle, position_}; }
  const JointValues& position() const { return position_; }
  bool isAtRest() const;
  const ServojFollowing& following() const { return following_; }

 private:
  void lead();
  void stopOn();

  ServojSettings settings_;
  double silent_cycles_;
  ServojState state_ = ServojState::Waiting;
  CyclicTarget newest_;
  std::int64_t last_ = 0;  ///< cycle of the target that was newest in the last cycle
  double phase_ = 0.0;     ///< its own count of the targets' cycles
  double silent_ = 0.0;    ///< cycles without a new target
  JointServo servo_;
  JointValues position_;
  JointValues velocity_;
  ServojFollowing following_;
};

}  // namespace lamina
