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

/// How regularly a robot got targets.
struct ServojFollowing {
  std::size_t cycles = 0;   ///< number of cycles since the first target
  std::size_t bridged = 0;  ///< number of those without a new target
  std::size_t without = 0;  ///< number of those later than `CyclicTarget::ahead` of the last target
};

/// Simulates what `servojProgram` does on a robot: follows targets cycle by cycle, with joints that lag
/// behind, and brakes by itself if no target arrives for too long. Deterministic; allocates no memory.
class ServojFollower {
 public:
  /// @param lag_s  time constant of the joints
  /// @param start  positions of the joints [rad]
  ServojFollower(const ServojSettings& settings, double lag_s, const JointValues& start);

  /// Accepts a target, which replaces the one before.
  void hear(const CyclicTarget& target);
  /// Ends the program: the joints brake for good.
  void end();
  /// Runs one cycle.
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
  std::int64_t last_ = 0;  ///< cycle number of the newest target in the last cycle
  double phase_ = 0.0;     ///< its own count of cycles, which follows the numbers of the targets
  double silent_ = 0.0;    ///< number of cycles since the last new target
  JointServo servo_;
  JointValues position_;
  JointValues velocity_;
  ServojFollowing following_;
};

}  // namespace lamina
