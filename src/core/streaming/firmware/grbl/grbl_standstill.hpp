// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Decides when a machine certainly stands still. A single report of Idle may have been made before the last
/// command was begun, so two reports are needed that were requested at different times.
class GrblStandstill {
 public:
  /// Evaluates a report of Idle.
  /// @return whether the machine certainly stands still
  bool isCertainAt(double now) {
    constexpr double kApart = 0.05;  // s
    if (idle_since_ < 0.0) idle_since_ = now;
    return now >= idle_since_ + kApart;
  }
  /// States that the machine may move again, or that earlier reports do not count any longer.
  void restart() { idle_since_ = -1.0; }

 private:
  double idle_since_ = -1.0;  ///< the first Idle in a row; -1 if there is none
};

}  // namespace lamina
