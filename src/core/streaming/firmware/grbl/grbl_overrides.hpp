// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "lamina/streaming/job/live_change.hpp"

namespace lamina {

/// Changes the overrides of grbl to requested values. For each override one byte is sent at a time; the next
/// byte follows once the machine has reported the effect. grbl may count several equal bytes as one: sent at
/// once, they would give an unknown value.
class GrblOverrides {
 public:
  /// Requests a change.
  /// @return why it is refused, in words; empty if it is accepted
  std::string set(const LiveChange& change, double now);
  /// Evaluates the values that the machine reports, after a change and at intervals.
  void hear(const GrblPercents& reported, double now);
  /// The bytes to send next; empty while a report is due.
  std::string takeBytes();
  /// Whether a change is in progress. The machine should then be polled more often.
  bool isUnderWay() const { return feed_ || rapid_ || spindle_; }
  /// Gives up if the machine reports no overrides for 5 s, or has not reached the values within 30 s.
  /// @return what was not reported, in words; empty if nothing is given up
  std::string giveUp(double now);

 private:
  std::optional<GrblPercents> reported_;  ///< values of the last report, if no bytes were sent for it yet
  std::optional<int> feed_;               ///< requested value [%]
  std::optional<int> rapid_;
  std::optional<int> spindle_;
  double asked_s_ = 0.0;
  double heard_s_ = 0.0;
};

}  // namespace lamina
