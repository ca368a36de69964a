// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "lamina/streaming/job/stream_job.hpp"

namespace lamina {

/// Finds the places where the machine stood still because it had no further motion. What the firmware reports
/// of its planner decides where it does so; elsewhere it is reckoned from the answers: firmware whose answer
/// is late waits for room, so that its planner is full, and what it has taken since lasts as long as the
/// motions take at their feeds. A host that was held up reads an answer late itself: so an answer that comes
/// later than all that a planner can hold lasts is starvation too. Pauses below 50 ms are not told:
/// acceleration makes motions longer than that.
class StarvationWatch {
 public:
  /// @param seconds  of its motions; 0 for a command without
  void sent(std::uint64_t line, double seconds, double now) {
    under_way_.push_back({line, seconds, now, false});
  }
  /// A command that the machine waits for standing still.
  void sentWait(std::uint64_t line, double now) { under_way_.push_back({line, 0.0, now, true}); }
  /// @param free_blocks  of the planner, if the firmware reports them
  void acknowledged(std::uint64_t line, std::optional<int> free_blocks, double now);
  /// The lines from this one on were not taken, and will be sent again.
  void rewound(std::uint64_t line);
  /// The machine says that it works on what it has.
  void busy(double now) { taken_at_ = now; }
  /// The machine stands still for a reason, such as a pause.
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
  double held_up_s_ = 0.0;  ///< what the last line came later than all that a planner holds lasts
  double taken_at_ = 0.0;   ///< of the last line that was
  int most_free_ = 0;
  bool is_moving_ = false;
};

}  // namespace lamina
