// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trajectory/joint_curve.hpp"

namespace lamina {

enum class PhaseKind : std::uint8_t {
  Move,
  Wait,  ///< at rest, for a wait of the job
  Halt,  ///< at rest, paused, with the process switched off
};

/// A stretch of time with constant acceleration along one span of a curve.
struct Phase {
  double time_s = 0.0;  ///< start of the phase
  const JointCurve* curve = nullptr;
  double along = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  std::uint32_t span = 0;
  PhaseKind kind = PhaseKind::Move;

  double alongAfter(double local_s) const { return along + local_s * (speed + 0.5 * acceleration * local_s); }
  double speedAfter(double local_s) const { return speed + acceleration * local_s; }
};

/// Position and speed of a motion on its curve.
struct MotionPlace {
  const JointCurve* curve = nullptr;
  std::uint32_t span = 0;
  double along = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  PhaseKind kind = PhaseKind::Move;
};

/// A sequence of phases without gaps, beginning at time 0.
class Timeline {
 public:
  /// Adds a phase of that duration, unless it is 0.
  void append(Phase phase, double duration_s);
  /// Adds the phases of another timeline from index `from` on, with their motions slowed down.
  /// @param share  factor on their speeds, (0, 1]
  void append(const Timeline& other, std::size_t from, double share);
  /// Adds a motion at constant acceleration between two positions of a span, from squared speed to squared
  /// speed.
  void appendStretch(const MotionPlace& start, double length, double exit2);
  /// Removes everything at or after a time.
  void cut(double time_s);

  bool isEmpty() const { return phases_.empty(); }
  double end() const { return end_s_; }
  const std::vector<Phase>& phases() const { return phases_; }
  double endOf(std::size_t phase) const {
    return phase + 1 < phases_.size() ? phases_[phase + 1].time_s : end_s_;
  }
  /// Index of the phase at a time; the first one before time 0, the last one after the end.
  std::size_t phaseAt(double time_s) const;
  /// Position and speed at a time; at rest before time 0 and after the end.
  MotionPlace placeAt(double time_s) const;

 private:
  std::vector<Phase> phases_;
  double end_s_ = 0.0;
};

}  // namespace lamina
