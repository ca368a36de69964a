// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// Notices that nothing comes any more. Time counts while somebody looks: a node that did not run itself
/// cannot know that others were silent.
class SilenceWatch {
 public:
  /// @param longest_s  without news [s]; 0: no silence is too long
  explicit SilenceWatch(double longest_s) : longest_s_(longest_s) {}

  /// Somebody looks; to be called all the time.
  /// @param news   changes with everything that comes
  /// @param now_s  on a steady clock
  /// @return whether nothing has come for longer than that
  bool look(std::uint64_t news, double now_s);

 private:
  double longest_s_;
  std::uint64_t news_ = 0;
  double looked_at_s_ = 0.0;
  double silent_s_ = 0.0;
};

}  // namespace lamina
