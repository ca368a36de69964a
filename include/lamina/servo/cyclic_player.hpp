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

/// Why a player has braked by itself.
struct CyclicFault {
  enum class Kind : std::uint8_t {
    Starved,  ///< the points end in motion, and no more came in time
    Late,     ///< a cycle came too late
    Step,     ///< a target was further away than the joint may go in the time
  };
  Kind kind = Kind::Starved;
  std::size_t joint = 0;  ///< of `Step`
  double value = 0.0;     ///< lateness or duration [s], or way [mm, rad]
  double most = 0.0;      ///< that was allowed
};

/// In words, with value and bound.
std::string faultText(const CyclicFault& fault, const std::vector<DrivenJoint>& joints);

/// Plays chunks of a trajectory as a target each cycle: on cubics through their points and velocities. To
/// brake, it goes on along the points, slower and slower until it rests; only where they end before that does
/// it go straight on. Where the points end in motion it brakes so early that it rests on them. What it does
/// follows from the times it is given alone. `advance` takes no memory from the heap; nothing may be called
/// at the same time.
class CyclicPlayer {
 public:
  /// @param sink  of which cycle and way ahead count
  /// @throws InvalidConfig naming key, value and bound
  CyclicPlayer(std::vector<DrivenJoint> joints, const CyclicSettings& settings, const CyclicSink& sink);

  /// Forgets all, and rests where the robot is.
  void begin(const JointValues& position);

  /// Takes points; those it has at or after the first of them are dropped.
  /// @param now_s  by the clock of the points
  /// @throws InvalidInput naming joint, value and bound if a point is out of the joint's limits or speed,
  ///   times do not rise, all points are past, the first is not where the robot is or is planned to be, or
  ///   the motion cannot be joined in time any more, and while it brakes; then nothing changes
  void accept(const TrajectoryChunk& chunk, double now_s);
  /// Brakes from the next cycle on; does nothing at rest.
  void brake() { is_brake_requested_ = !points_.empty(); }

  /// The target of the last cycle that is due; null if that was given already.
  /// @param due_s  when the first cycle was due that has not been given
  /// @param now_s  not before that
  const CyclicTarget* advance(double due_s, double now_s);

  /// Whether nothing is left to follow.
  bool isAtRest() const { return points_.empty(); }
  bool isBraking() const { return brake_.has_value(); }
  /// Why it has braked since the last `begin` or chunk that was accepted from rest.
  const std::optional<CyclicFault>& fault() const { return fault_; }
  /// The last target.
  const CyclicTarget& target() const { return target_; }

 private:
  struct Point {
    double time_s = 0.0;
    JointValues position;
    JointValues velocity;
  };
  /// From `begin_s` on the time of the points slows down, until it stands after `duration_s`.
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
  std::optional<double> last_due_s_;  ///< when the last target was due
  CyclicTarget target_;
};

}  // namespace lamina
