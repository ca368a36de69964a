// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/motion_planner.hpp"

namespace lamina {

/// A straight motion that the firmware requests.
struct RequestedMotion {
  Point3 start = Point3::Zero();  ///< [mm, bed]
  Point3 end = Point3::Zero();    ///< [mm, bed]
  double filament_mm = 0.0;
  double feed_mm_s = 0.0;
};

/// A straight motion the machine has run, with machine times.
struct ExecutedMotion {
  Point3 start = Point3::Zero();  ///< [mm, bed]
  Point3 end = Point3::Zero();    ///< [mm, bed]
  double filament_mm = 0.0;
  double start_s = 0.0;
  double end_s = 0.0;
  SpeedProfile profile;  ///< along the requested motion, of which a quick stop leaves only the first part

  /// The nozzle at a machine time, which is clamped to the motion [mm, bed].
  Point3 positionAt(double time_s) const;
  /// Machine time at which the nozzle has gone the share `part` of the way, from 0 at the start to 1 at the
  /// end.
  double timeAt(double part) const;
};

/// The motions of an emulated machine: a queue of blocks with look-ahead over the whole queue, run one after
/// the other in machine time. A block that has begun is no longer changed. The nozzle stops when the queue
/// runs empty.
class EmulatedMotion {
 public:
  using Observer = std::function<void(const ExecutedMotion&)>;

  /// @param capacity  blocks that wait behind the running one
  /// @param observer  given every motion when it has ended, in order; may be empty
  EmulatedMotion(const MotionLimits& limits, std::size_t capacity, Observer observer);

  bool isFull() const { return waiting_.size() >= capacity_; }
  bool isEmpty() const { return waiting_.empty() && !running_; }
  /// Adds a motion at machine time `now_s`. A motion without length and filament is ignored.
  void add(const RequestedMotion& motion, double now_s);

  /// Runs everything up to machine time `now_s`.
  void advance(double now_s);
  /// Time at which the running block ends, or the next one begins if none runs; none if the queue is empty.
  std::optional<double> nextEvent() const;

  /// Stops at once, wherever the nozzle is, and forgets the queue.
  void quickStop(double now_s);
  /// Puts the nozzle elsewhere without a motion.
  void place(const Point3& position) { position_ = position; }

  Point3 positionAt(double now_s) const;
  double filament() const { return filament_mm_; }          ///< pushed forth so far [mm]
  std::size_t starvations() const { return starvations_; }  ///< times the queue ran empty

 private:
  struct Block {
    RequestedMotion motion;
    MotionSegment segment;
    double entry_limit2 = 0.0;  ///< squared speeds [mm²/s²]
    double entry2 = 0.0;
  };

  MotionSegment segmentOf(const RequestedMotion& motion) const;
  void plan();
  void begin(double at_s);
  void end();

  MotionLimits limits_;
  std::size_t capacity_;
  Observer observer_;
  std::deque<Block> waiting_;
  std::optional<ExecutedMotion> running_;
  MotionSegment last_segment_;  ///< of the block added last
  double begin_at_ = 0.0;       ///< of the first waiting block, if none runs
  Point3 position_ = Point3::Zero();
  double filament_mm_ = 0.0;
  std::size_t starvations_ = 0;
};

}  // namespace lamina
