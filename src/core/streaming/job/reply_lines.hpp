// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace lamina {

/// Splits bytes of a machine into lines. More than 4096 bytes without an end of line are noise and dropped.
class ReplyLines {
 public:
  void add(std::string_view bytes) {
    received_.erase(0, std::exchange(read_, 0));
    received_ += bytes;
  }

  /// The next complete line, without its end; nothing if there is none.
  std::optional<std::string> next() {
    constexpr std::size_t kLongest = 4096;
    const std::size_t end = received_.find('\n', read_);
    if (end == std::string::npos) {
      if (received_.size() - read_ > kLongest) clear();
      return std::nullopt;
    }
    std::string line = received_.substr(read_, end - read_);
    read_ = end + 1;
    return line;
  }

  /// Removes and returns the bytes not read yet.
  std::string takeRest() {
    std::string rest = received_.substr(read_);
    clear();
    return rest;
  }

  void clear() {
    received_.clear();
    read_ = 0;
  }

 private:
  std::string received_;
  std::size_t read_ = 0;  ///< number of bytes returned
};

}  // namespace lamina
