// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <utility>

namespace lamina {

/// Replies on their way to the host, in order; a delayed one holds back all that follow.
class ReplyQueue {
 public:
  void say(std::string_view text) { (held_.empty() ? ready_ : held_.back().text) += text; }
  /// Everything said from now on is held until `wall_s`.
  void holdUntil(double wall_s) { held_.push_back({wall_s, {}}); }
  void elapse(double wall_s) {
    for (; !held_.empty() && held_.front().until <= wall_s; held_.pop_front()) ready_ += held_.front().text;
  }
  double nextDeadline(double otherwise) const { return held_.empty() ? otherwise : held_.front().until; }
  std::string take() { return std::exchange(ready_, {}); }
  void clear() {
    ready_.clear();
    held_.clear();
  }

 private:
  struct Held {
    double until = 0.0;
    std::string text;
  };
  std::string ready_;
  std::deque<Held> held_;
};

}  // namespace lamina
