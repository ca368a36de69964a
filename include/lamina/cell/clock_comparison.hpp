// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

namespace lamina {

/// The four time stamps of a question and its answer between two hosts [s since 1970, each by the clock of
/// the host that took it].
struct ClockExchange {
  double asked_s = 0.0;     ///< question sent by this host
  double received_s = 0.0;  ///< question received by the other host
  double answered_s = 0.0;  ///< answer sent by the other host
  double heard_s = 0.0;     ///< answer received by this host
};

/// Time by which another clock is ahead of this one, and its uncertainty [s].
struct ClockOffset {
  double offset_s = 0.0;
  double uncertainty_s = 0.0;  ///< half the round trip, since all of it may have been spent in one direction
};

/// The offset by one exchange. Source: RFC 5905 (NTP), section 8.
ClockOffset offsetOf(const ClockExchange& exchange);

/// The offset of another host's clock, by many exchanges with it.
class ClockComparison {
 public:
  /// Adds an exchange. One whose time stamps contradict each other (an answer before its question) is
  /// ignored.
  void add(const ClockExchange& exchange);

  /// The medians of offset and of uncertainty over the last 16 exchanges; nothing before there are 16.
  std::optional<ClockOffset> offset() const;

  /// Removes all exchanges: they are of no use after a step of either clock.
  void forget() { last_.clear(); }

 private:
  std::deque<ClockOffset> last_;
};

}  // namespace lamina
