// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "lamina/streaming/job/live_change.hpp"

namespace lamina {

/// The overrides of grbl on their way to what a person has asked for: a byte for each at a time, and the next
/// once the machine has reported what the last one did. grbl takes equal bytes that come between two of its
/// looks for one, so that several at once would lead anywhere.
class GrblOverrides {
 public:
  /// @return why it is refused, in words; empty if it is taken
  std::string set(const LiveChange& change, double now);
  /// What the machine reports, which it does after a change and now and then.
  void hear(const GrblPercents& reported, double now);
  /// The bytes to send next; empty where a report is to be waited for.
  std::string takeBytes();
  /// Whether the machine is to be asked more often than usual.
  bool isUnderWay() const { return feed_ || rapid_ || spindle_; }
  /// Gives up on a machine that reports none for five seconds, or has not become what was asked for
  /// within 30.
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
