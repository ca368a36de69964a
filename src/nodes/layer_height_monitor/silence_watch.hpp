// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// Detects silence. Only time between frequent calls of `look` counts: a node that did not run itself cannot
/// know that others were silent.
class SilenceWatch {
 public:
  /// @param longest_s  without news [s]; 0: no silence is too long
  explicit SilenceWatch(double longest_s) : longest_s_(longest_s) {}

  /// Checks for silence; to be called continually.
  /// @param news   number that changes with everything that arrives
  /// @param now_s  on a steady clock
  /// @return whether nothing has arrived for longer than `longest_s`
  bool look(std::uint64_t news, double now_s);

 private:
  double longest_s_;
  std::uint64_t news_ = 0;
  double looked_at_s_ = 0.0;
  double silent_s_ = 0.0;
};

}  // namespace lamina
