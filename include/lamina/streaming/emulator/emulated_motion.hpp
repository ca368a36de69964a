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
  Point3 start = Point3::Zero();  ///< position of the nozzle [mm, frame of the bed]
  Point3 end = Point3::Zero();    ///< position of the nozzle [mm, frame of the bed]
  double filament_mm = 0.0;       ///< length of filament extruded; negative if it is retracted
  double feed_mm_s = 0.0;
};

/// A straight motion that the machine has run.
struct ExecutedMotion {
  Point3 start = Point3::Zero();  ///< position of the nozzle [mm, frame of the bed]
  Point3 end = Point3::Zero();    ///< position of the nozzle [mm, frame of the bed]
  double filament_mm = 0.0;       ///< length of filament extruded; negative if it was retracted
  double start_s = 0.0;           ///< machine time
  double end_s = 0.0;             ///< machine time
  SpeedProfile profile;           ///< of the whole requested motion, even if a quick stop has cut it short

  /// Position of the nozzle [mm, frame of the bed] at a machine time, which is clamped to the motion.
  Point3 positionAt(double time_s) const;
  /// Machine time at which the nozzle has covered the share `part` of the distance, from 0 at the start to 1
  /// at the end.
  double timeAt(double part) const;
};

/// Motion planner of an emulated machine: a queue of motions (blocks) with look-ahead over the whole queue,
/// run one after the other in machine time. The speeds of a block no longer change once it runs. The nozzle
/// stops when the queue runs empty.
class EmulatedMotion {
 public:
  using Observer = std::function<void(const ExecutedMotion&)>;

  /// @param capacity  number of blocks that may wait behind the running one, at least 1
  /// @param observer  called with each motion when it has ended, in order; may be empty
  EmulatedMotion(const MotionLimits& limits, std::size_t capacity, Observer observer);

  bool isFull() const { return waiting_.size() >= capacity_; }
  bool isEmpty() const { return waiting_.empty() && !running_; }
  /// Adds a motion at machine time `now_s`. A motion with neither length nor filament is ignored.
  void add(const RequestedMotion& motion, double now_s);

  /// Runs the motions up to machine time `now_s`.
  void advance(double now_s);
  /// Machine time at which the running block ends, or the next one begins if none runs; nothing if there is
  /// no block.
  std::optional<double> nextEvent() const;

  /// Stops the nozzle at once, wherever it is, and discards the queue.
  void quickStop(double now_s);
  /// Sets the position of the nozzle without a motion.
  void place(const Point3& position) { position_ = position; }

  Point3 positionAt(double now_s) const;                    ///< of the nozzle [mm, frame of the bed]
  double filament() const { return filament_mm_; }          ///< length extruded so far, net [mm]
  std::size_t starvations() const { return starvations_; }  ///< times that the queue ran empty

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
  double begin_at_ = 0.0;       ///< machine time at which the first waiting block begins, if none runs
  Point3 position_ = Point3::Zero();
  double filament_mm_ = 0.0;
  std::size_t starvations_ = 0;
};

}  // namespace lamina
