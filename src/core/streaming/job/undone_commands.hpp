// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace lamina {

/// Counts commands that the firmware acknowledged without running them. A command that it requests again does
/// not count.
class UndoneCommands {
 public:
  /// States that the firmware has announced, before the ok, that it will not run a line.
  void announce() { is_announced_ = true; }

  /// States that a line was acknowledged.
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
