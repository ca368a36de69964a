// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <utility>

namespace lamina {

/// Delays the use of what arrives: messages sent at the same time on another connection then arrive before.
class ArrivalHold {
 public:
  /// @param hold_s  real time
  explicit ArrivalHold(double hold_s) : hold_s_(hold_s) {}

  /// @param now_s  on a steady clock
  void add(double now_s, std::function<void()> use);
  /// Uses everything that was kept long enough, in the order of arrival.
  void release(double now_s);
  /// Uses all.
  void releaseAll();

 private:
  double hold_s_;
  std::deque<std::pair<double, std::function<void()>>> kept_;
};

}  // namespace lamina
