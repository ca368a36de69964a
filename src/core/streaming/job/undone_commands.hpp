// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace lamina {

/// The commands that the firmware did not run as they were asked for. One that it asks for again was none.
class UndoneCommands {
 public:
  /// What the firmware says before the ok of such a line.
  void announce() { is_announced_ = true; }

  /// @param line  that was acknowledged
  void acknowledge(std::uint64_t line) {
    constexpr std::size_t kRemembered = 1024;  // lines that can be asked for again
    if (!std::exchange(is_announced_, false)) return;
    lines_.push_back(line);
    if (lines_.size() <= kRemembered) return;
    lines_.pop_front();
    ++before_;
  }

  void rewind(std::uint64_t line) {
    is_announced_ = false;
    while (!lines_.empty() && lines_.back() >= line) lines_.pop_back();
  }

  std::uint64_t count() const { return before_ + lines_.size(); }

 private:
  std::deque<std::uint64_t> lines_;
  std::uint64_t before_ = 0;
  bool is_announced_ = false;
};

}  // namespace lamina
