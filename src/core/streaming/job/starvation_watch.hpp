// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "lamina/streaming/job/stream_job.hpp"

namespace lamina {

/// Finds the lines before which the machine stood still for want of a motion. If the firmware reports its
/// planner, that report decides. Otherwise the answers do: firmware that answers late waits for room, so its
/// planner is full, and the motions taken since then last for their time at their feeds. An answer later than
/// a full planner lasts counts as starvation too, since a host that was held up reads answers late. Pauses
/// below 50 ms are not counted, since acceleration lengthens motions by more than that.
class StarvationWatch {
 public:
  /// @param seconds  time of its motions; 0 for a command without motion
  void sent(std::uint64_t line, double seconds, double now) {
    under_way_.push_back({line, seconds, now, false});
  }
  /// Takes a command for which the machine stands still.
  void sentWait(std::uint64_t line, double now) { under_way_.push_back({line, 0.0, now, true}); }
  /// @param free_blocks  of the planner, if the firmware reports them
  void acknowledged(std::uint64_t line, std::optional<int> free_blocks, double now);
  /// States that the lines from this one on were not taken and will be sent again.
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
  std::deque<double> recent_;  ///< durations of the motions taken last [s]
  double runs_dry_at_ = 0.0;
  double held_up_s_ = 0.0;  ///< delay of the last line beyond the time of a full planner
  double taken_at_ = 0.0;   ///< of the last line that was
  int most_free_ = 0;
  bool is_moving_ = false;
};

}  // namespace lamina
