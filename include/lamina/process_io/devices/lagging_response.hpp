// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <deque>
#include <utility>

namespace lamina {

/// A response that follows its input after a dead time, with a lag of first order. It is exact at any time,
/// by the closed solution from one change of the input to the next.
class LaggingResponse {
 public:
  LaggingResponse(double dead_time_s, double lag_s) : dead_time_s_(dead_time_s), lag_s_(lag_s) {}

  /// Sets the input; times must not go back.
  void send(double value, double now_s) { sent_.emplace_back(now_s + dead_time_s_, value); }

  /// The response at a time, which must not go back.
  double effectAt(double time_s) {
    while (!sent_.empty() && sent_.front().first <= time_s) {
      advance(sent_.front().first);
      input_ = sent_.front().second;
      if (lag_s_ <= 0.0) effect_ = input_;
      sent_.pop_front();
    }
    advance(time_s);
    return effect_;
  }

 private:
  void advance(double time_s) {
    if (lag_s_ > 0.0) effect_ = input_ + (effect_ - input_) * std::exp(-(time_s - at_s_) / lag_s_);
    at_s_ = time_s;
  }

  double dead_time_s_;
  double lag_s_;
  std::deque<std::pair<double, double>> sent_;
  double at_s_ = 0.0;
  double input_ = 0.0;
  double effect_ = 0.0;
};

}  // namespace lamina
