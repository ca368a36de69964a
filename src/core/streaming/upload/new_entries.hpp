// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// Finds the new entries of a list that is read repeatedly, while entries are added at its end and removed at
/// its beginning. An entry is recognised by its whole text, since its time may be wrong.
class NewEntries {
 public:
  /// Whether the last entry taken is still in the list, or none was taken yet.
  bool isKnownIn(const std::vector<std::string>& list) const {
    return !last_ || std::find(list.rbegin(), list.rend(), *last_) != list.rend();
  }

  /// @return index of the first new entry. In the first list none is new; all are if the last known entry was
  ///   removed
  std::size_t takeNew(const std::vector<std::string>& list) {
    const std::optional<std::string> before = last_;
    const bool is_first = !std::exchange(has_begun_, true);
    if (!list.empty()) last_ = list.back();
    if (is_first) return list.size();
    if (!before) return 0;
    const auto known = std::find(list.rbegin(), list.rend(), *before);
    return static_cast<std::size_t>(list.rend() - known);
  }

 private:
  std::optional<std::string> last_;  ///< nothing where every list was empty
  bool has_begun_ = false;
};

}  // namespace lamina
