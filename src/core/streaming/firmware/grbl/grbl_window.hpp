// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

namespace lamina {

/// The lines sent and not yet answered, with their number of characters, the most that they fill of the
/// receive buffer.
class GrblWindow {
 public:
  struct Line {
    std::uint64_t number = 0;  ///< of the program; 0 for a question of the streamer
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
  /// Removes the first line, which was answered.
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
