// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

namespace lamina {

/// The four stamps of a question and its answer between two hosts [s since 1970, each by the clock of the
/// host that took it].
struct ClockExchange {
  double asked_s = 0.0;     ///< here
  double received_s = 0.0;  ///< there
  double answered_s = 0.0;  ///< there
  double heard_s = 0.0;     ///< here
};

/// How far another clock is ahead of this one, and by how much that may be wrong [s].
struct ClockOffset {
  double offset_s = 0.0;
  double uncertainty_s = 0.0;  ///< half the round trip: the way there may have taken all of it
};

/// Source: RFC 5905 (NTP), section 8.
ClockOffset offsetOf(const ClockExchange& exchange);

/// What many exchanges with one host say of its clock.
class ClockComparison {
 public:
  /// Exchanges whose stamps contradict each other (an answer before its question) are left out.
  void add(const ClockExchange& exchange);

  /// The medians of the last 16 exchanges, of offset and uncertainty apart; nothing before there are 16.
  std::optional<ClockOffset> offset() const;

  /// What was before a step of either clock says nothing of now.
  void forget() { last_.clear(); }

 private:
  std::deque<ClockOffset> last_;
};

}  // namespace lamina
