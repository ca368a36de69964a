// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Whether a command was run, as the machine's position tells.
enum class RunEvidence : std::uint8_t {
  Ran,
  DidNotRun,
  None,  ///< the command does not show, or the position is neither that before nor that behind it
};

/// Follows the position that G-code leads to, as far as it can be told, to see by the machine's whether a
/// command was run. Coordinates are in program units, as the firmware counts them; what is not known is left
/// open.
class MotionTracker {
 public:
  /// The machine's position is known.
  void locate(const ReportedPosition& position);
  /// Whether it needs the position to tell later if this command was run.
  bool needsPosition(std::string_view command) const;
  /// The command goes out: what it leads to is worked out.
  void expect(std::string_view command);
  /// The command given last was run.
  void confirm() { now_ = next_; }

  /// Whether the command given last was run, if this is where the machine is.
  RunEvidence evidence(const ReportedPosition& found) const;
  /// Whether a second run of the command given last, at once after the first, changes nothing.
  bool isRepeatable() const { return is_repeatable_; }
  /// How long the command given last may take as a motion [s]; 0 if it is none or cannot be told.
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
