// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Whether a command was run, as judged by the machine's position.
enum class RunEvidence : std::uint8_t {
  Ran,
  DidNotRun,
  None,  ///< the position does not show it: it is the same before and after, or the machine is elsewhere
};

/// Follows the position to which G-code leads, as far as it is known. Comparison with the machine's position
/// then shows whether a command was run. Coordinates are in program units, as the firmware counts them.
class MotionTracker {
 public:
  /// Sets the machine's position.
  void locate(const ReportedPosition& position);
  /// Whether the position must be known before this command, to decide later whether it was run.
  bool needsPosition(std::string_view command) const;
  /// Computes the position after a command that is about to be sent.
  void expect(std::string_view command);
  /// States that the last command was run.
  void confirm() { now_ = next_; }

  /// Whether the last command was run, if the machine reports that position.
  RunEvidence evidence(const ReportedPosition& found) const;
  /// Whether running the last command twice in a row is the same as once.
  bool isRepeatable() const { return is_repeatable_; }
  /// Time that the motion of the last command may take [s]; 0 if it has none or it is not known.
  double seconds() const { return seconds_; }

 private:
  enum Coordinate : std::uint8_t { kX, kY, kZ, kE, kCount };

  /// Modes and position; each is nothing where unknown.
  struct State {
    std::array<std::optional<double>, kCount> at;
    std::optional<bool> is_relative;
    std::optional<bool> is_filament_relative;
    bool is_metric = true;
    double feed_mm_min = 0.0;  ///< 0 if unknown
  };

  void move(std::string_view words);
  void place(std::string_view words);
  void forgetPosition();
  static double wayFrom(const State& start, const State& end);

  State now_;
  State next_;
  bool is_repeatable_ = false;
  double seconds_ = 0.0;
};

}  // namespace lamina
