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
/// its beginning. Entries are recognised by their whole text, as their times may be wrong.
class NewEntries {
 public:
  /// Whether the list still has the last known entry, or there is no known entry yet.
  bool isKnownIn(const std::vector<std::string>& list) const {
    return !last_ || std::find(list.rbegin(), list.rend(), *last_) != list.rend();
  }

  /// Takes note of the list's entries.
  /// @return index of the first new entry. In the first list none is new; if the last known entry was
  ///   removed, all are
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
  std::optional<std::string> last_;  ///< the last known entry; nothing as long as every list was empty
  bool has_begun_ = false;
};

}  // namespace lamina
