// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lamina/streaming/job/stream_settings.hpp"

namespace lamina {

/// The commands that request temperatures and position, at the shorter of the two intervals.
class ReportPoll {
 public:
  explicit ReportPoll(const StreamSettings& settings) {
    const auto least = [](int a, int b) { return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b); };
    interval_s_ = least(settings.temperature_interval_s, settings.position_interval_s);
    if (settings.temperature_interval_s > 0) commands_.emplace_back("M105");
    if (settings.position_interval_s > 0) commands_.emplace_back("M114");
  }

  /// The commands, if they are due; they are due again after the interval.
  std::vector<std::string> takeDue(double now) {
    if (interval_s_ == 0 || now < next_s_) return {};
    next_s_ = now + interval_s_;
    return commands_;
  }

 private:
  int interval_s_ = 0;  ///< 0 for never
  std::vector<std::string> commands_;
  double next_s_ = 0.0;
};

}  // namespace lamina
