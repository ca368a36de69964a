// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "lamina/streaming/job/stream_job.hpp"

namespace lamina {

/// Finds the lines before which the machine stood still because no motion had arrived. If the firmware
/// reports its planner, the reports decide. Otherwise the times of the answers decide. A late answer means
/// that the firmware was waiting for room in a full planner: the motions accepted since then keep it busy for
/// their time at their feeds. An answer later than the duration of a full planner also counts as starvation,
/// as a delayed host reads answers late. Standstill below 50 ms is not counted, as acceleration lengthens
/// motions by more than that.
class StarvationWatch {
 public:
  /// States that a line was sent.
  /// @param seconds  time of its motions; 0 for a command without motion
  void sent(std::uint64_t line, double seconds, double now) {
    under_way_.push_back({line, seconds, now, false});
  }
  /// States that a command was sent for which the machine stands still.
  void sentWait(std::uint64_t line, double now) { under_way_.push_back({line, 0.0, now, true}); }
  /// States that a line was acknowledged.
  /// @param free_blocks  free blocks of the planner, if the firmware reports them
  void acknowledged(std::uint64_t line, std::optional<int> free_blocks, double now);
  /// States that the lines from this one on were not accepted and will be sent again.
  void rewound(std::uint64_t line);
  /// States that the machine reports to be busy.
  void busy(double now) { taken_at_ = now; }
  /// States that the machine stands still for another reason, such as a pause.
  void standStill() { is_moving_ = false; }

  const Starvation& starvation() const { return starvation_; }

 private:
  struct Line {
    std::uint64_t number;
    double seconds;
    double sent_at;
    bool waits;
  };

  void take(const Line& line, std::optional<int> free_blocks, double now);
  double pauseBefore(const Line& line, std::optional<int> free_blocks, double now);
  double contentOf(std::size_t motions) const;

  Starvation starvation_;
  std::deque<Line> under_way_;
  std::deque<double> recent_;  ///< durations of the last motions accepted [s]
  double runs_dry_at_ = 0.0;
  double held_up_s_ = 0.0;  ///< delay of the last line beyond the time of a full planner
  double taken_at_ = 0.0;   ///< time at which the last line was accepted
  int most_free_ = 0;
  bool is_moving_ = false;
};

}  // namespace lamina
