// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

namespace lamina {

/// The lines sent and not yet answered, counted by their characters, which is how much of the receive buffer
/// they may fill.
class GrblWindow {
 public:
  struct Line {
    std::uint64_t number = 0;  ///< of the program; 0 if it is a question of ours
    std::string command;
  };

  bool empty() const { return lines_.empty(); }
  std::size_t count() const { return lines_.size(); }
  std::size_t bytes() const { return bytes_; }
  const Line& front() const { return lines_.front(); }
  bool hasQuestion() const { return questions_ > 0; }

  void add(Line line) {
    bytes_ += line.command.size() + 1;
    if (line.number == 0) ++questions_;
    lines_.push_back(std::move(line));
  }
  /// The first line was answered.
  Line take() {
    Line line = std::move(lines_.front());
    lines_.pop_front();
    bytes_ -= line.command.size() + 1;
    if (line.number == 0) --questions_;
    return line;
  }
  void clear() { *this = {}; }

 private:
  std::deque<Line> lines_;
  std::size_t bytes_ = 0;
  int questions_ = 0;
};

}  // namespace lamina
