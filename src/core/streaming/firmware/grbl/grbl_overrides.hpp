// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "lamina/streaming/job/live_change.hpp"

namespace lamina {

/// Changes the overrides of grbl to requested values. It sends one byte for each at a time, and the next one
/// when the machine has reported the effect. grbl may take several equal bytes for one, so that sending them
/// together would give an unknown value.
class GrblOverrides {
 public:
  /// @return why it is refused, in words; empty if it is taken
  std::string set(const LiveChange& change, double now);
  /// Takes the values that the machine reports, after a change and at intervals.
  void hear(const GrblPercents& reported, double now);
  /// The bytes to send next; empty while a report is due.
  std::string takeBytes();
  /// Whether a change is under way, so that the machine is to be polled more often.
  bool isUnderWay() const { return feed_ || rapid_ || spindle_; }
  /// Gives up if the machine reports no overrides for five seconds, or has not reached the values within 30.
  /// @return what was not reached, in words; empty if nothing is given up
  std::string giveUp(double now);

 private:
  std::optional<GrblPercents> reported_;  ///< and not yet answered by bytes
  std::optional<int> feed_;               ///< wanted [%]
  std::optional<int> rapid_;
  std::optional<int> spindle_;
  double asked_s_ = 0.0;
  double heard_s_ = 0.0;
};

}  // namespace lamina
