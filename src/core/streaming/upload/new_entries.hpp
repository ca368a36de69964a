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

/// What is new in a list that is given again and again, at whose end entries are added and from whose
/// beginning they fall out. Clocks are not trusted: an entry is known again by its whole text.
class NewEntries {
 public:
  /// Whether the last entry taken is still in the list, or none was taken yet.
  bool isKnownIn(const std::vector<std::string>& list) const {
    return !last_ || std::find(list.rbegin(), list.rend(), *last_) != list.rend();
  }

  /// @return index of the first entry that is new. None is in the first list; all are where the last entry
  ///   known has fallen out
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
