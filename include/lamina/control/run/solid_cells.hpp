// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace lamina {

/// Counts the cells of a layer that the nozzle has left behind by a given time, for instance early enough to
/// be solid now.
class SolidCells {
 public:
  /// Begins a new layer, with no cell left behind.
  void begin() { left_.clear(); }
  /// States how many cells the nozzle has left behind at that time.
  void leaveBehind(std::int64_t stamp_ns, std::size_t cells) {
    if (left_.empty() || left_.back().second != cells) left_.emplace_back(stamp_ns, cells);
  }
  /// Number of cells left behind by that time, which must not be earlier than in the call before.
  std::size_t leftBehindBy(std::int64_t stamp_ns) {
    while (left_.size() > 1 && left_[1].first <= stamp_ns) left_.pop_front();
    return !left_.empty() && left_.front().first <= stamp_ns ? left_.front().second : 0;
  }

 private:
  std::deque<std::pair<std::int64_t, std::size_t>> left_;  ///< numbers of cells left behind, and since when
};

}  // namespace lamina
