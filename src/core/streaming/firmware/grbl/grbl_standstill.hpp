// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Certainty that a machine stands still. One report of Idle may be from before the last command was begun,
/// so that it takes two that were asked for apart.
class GrblStandstill {
 public:
  /// Takes a report of Idle.
  /// @return whether it is certain
  bool isCertainAt(double now) {
    constexpr double kApart = 0.05;  // s
    if (idle_since_ < 0.0) idle_since_ = now;
    return now >= idle_since_ + kApart;
  }
  /// States that the machine may move again, or that an earlier report counts no longer.
  void restart() { idle_since_ = -1.0; }

 private:
  double idle_since_ = -1.0;  ///< the first Idle in a row; -1 if there is none
};

}  // namespace lamina
