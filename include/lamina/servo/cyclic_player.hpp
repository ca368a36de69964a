// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/servo/cyclic_settings.hpp"
#include "lamina/servo/cyclic_sink.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// A fault at which a player has braked by itself.
struct CyclicFault {
  enum class Kind : std::uint8_t {
    Starved,  ///< the points ended in motion, and no more arrived in time
    Late,     ///< a cycle was called too late
    Step,     ///< a target was farther from the last one than the joint may move in between
  };
  Kind kind = Kind::Starved;
  std::size_t joint = 0;  ///< index of the joint, for Step
  double value = 0.0;     ///< Starved: time left; Late: lateness [s]; Step: distance [mm, rad]
  double most = 0.0;      ///< Starved: time needed; Late, Step: greatest value allowed
};

/// The fault in words, with value and bound.
std::string faultText(const CyclicFault& fault, const std::vector<DrivenJoint>& joints);

/// Converts chunks of a trajectory into a target for each cycle of a controller, on cubic polynomials through
/// their points and velocities. It brakes along the points, at a decreasing rate of time; if the points end
/// before it rests, it continues straight. If the points end in motion, it begins to brake early enough to
/// rest before their end. Deterministic: the only times it uses are its arguments. `advance` allocates no
/// memory. Not thread-safe.
class CyclicPlayer {
 public:
  /// @param sink  controller whose `cycle` and `ahead` are used
  /// @throws InvalidConfig naming key, value and bound
  CyclicPlayer(std::vector<DrivenJoint> joints, const CyclicSettings& settings, const CyclicSink& sink);

  /// Discards all points and faults, and rests at the robot's position.
  void begin(const JointValues& position);

  /// Adds points, which replace earlier points from the time of the first new point on.
  /// @param now_s  by the clock of the points
  /// @throws InvalidInput naming joint, value and bound, if a point exceeds the limits or the speed of a
  ///   joint, times do not ascend, all points are in the past, the first is not at the present or planned
  ///   position, or the motion cannot be joined in time; also while braking. Nothing changes then.
  void accept(const TrajectoryChunk& chunk, double now_s);
  /// Brakes from the next cycle on; without effect at rest.
  void brake() { is_brake_requested_ = !points_.empty(); }

  /// The target of the newest cycle that is due; null if it was returned already.
  /// @param due_s  time at which the first cycle without a call was due
  /// @param now_s  present time, at or after `due_s`
  const CyclicTarget* advance(double due_s, double now_s);

  /// Whether no points are left to follow.
  bool isAtRest() const { return points_.empty(); }
  bool isBraking() const { return brake_.has_value(); }
  /// The last fault since `begin`, or since a chunk was accepted at rest; nothing if there was none.
  const std::optional<CyclicFault>& fault() const { return fault_; }
  /// The last target that `advance` has returned.
  const CyclicTarget& target() const { return target_; }

 private:
  struct Point {
    double time_s = 0.0;
    JointValues position;
    JointValues velocity;
  };
  /// Braking: from `begin_s` on, when the points are followed at `path_s`, the rate at which their time
  /// passes decreases to 0 within `duration_s`.
  struct Brake {
    double begin_s = 0.0;
    double path_s = 0.0;
    double duration_s = 0.0;
  };
  void requireFeasible(const TrajectoryChunk& chunk) const;
  void requireJoined(const TrajectoryChunk& chunk, double now_s) const;
  bool isMoving(const Point& point) const;
  JointTarget onPoints(double path_s) const;
  double rateAt(double time_s) const;
  double pathTime(double time_s) const;
  JointTarget at(double time_s) const;
  double brakeTimeFrom(double path_s) const;
  void startBraking(double time_s, double path_s);
  void watch(double newest_s, double late_s);
  std::optional<CyclicFault> tooFar(const JointTarget& asked, double elapsed_s) const;
  void brakeStraight();
  void settle(double time_s);

  std::vector<DrivenJoint> joints_;
  CyclicSettings settings_;
  double cycle_s_;
  double ahead_s_;
  double tolerance_;
  std::vector<Point> points_;  ///< empty at rest
  std::size_t passed_ = 0;     ///< index of the last point passed
  std::optional<Brake> brake_;
  std::optional<CyclicFault> fault_;
  bool is_brake_requested_ = false;
  std::optional<double> last_due_s_;  ///< time at which the last target was due
  CyclicTarget target_;
};

}  // namespace lamina
