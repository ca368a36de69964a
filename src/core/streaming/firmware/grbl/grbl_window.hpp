// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

namespace lamina {

/// Lines sent and not yet answered, with their sizes. grbl's receive buffer can hold no other lines. A
/// question has an answer of its own before its ok; this answer is used to verify the count of answers.
class GrblWindow {
 public:
  struct Line {
    std::uint64_t number = 0;  ///< line number of the program; 0 for a question of the streamer
    std::string command;
  };

  bool empty() const { return lines_.empty(); }
  std::size_t count() const { return lines_.size(); }
  const Line& front() const { return lines_.front(); }
  bool hasQuestion() const { return questions_ > 0; }

  /// Sets the greatest number of bytes sent and not yet answered.
  void setCapacity(std::size_t bytes) { capacity_ = bytes; }
  bool hasRoom(std::size_t bytes) const {
    // grbl has removed answered lines from its buffer: it reads a line that is alone there at once.
    return empty() || bytes_ + bytes <= capacity_;
  }

  void add(Line line) {
    bytes_ += line.command.size() + 1;
    if (line.number == 0) ++questions_;
    lines_.push_back(std::move(line));
  }
  /// Evaluates the answer to a question, which precedes the ok.
  /// @return how the answer contradicts the count, in words; empty if it agrees
  std::string hearAnswer() {
    if (empty()) return {};  // somebody else's question
    if (front().number > 0)
      return "a question behind line " + std::to_string(front().number) + " was answered, the line was not";
    is_question_answered_ = true;
    return {};
  }
  /// Evaluates an ok; to be called before `take`.
  /// @return how the ok contradicts the count, in words; empty if it agrees
  std::string hearOk() {
    if (empty()) return "a line was answered that was not sent";
    if (front().number == 0 && !std::exchange(is_question_answered_, false))
      return "an answer came more than lines were sent";
    return {};
  }
  /// Removes the first line, which was answered.
  Line take() {
    Line line = std::move(lines_.front());
    lines_.pop_front();
    bytes_ -= line.command.size() + 1;
    if (line.number == 0) --questions_;
    return line;
  }
  void clear() {
    lines_.clear();
    bytes_ = 0;
    questions_ = 0;
    is_question_answered_ = false;
  }

 private:
  std::deque<Line> lines_;
  std::size_t bytes_ = 0;
  std::size_t capacity_ = 0;
  int questions_ = 0;
  bool is_question_answered_ = false;  ///< whether the first line was answered, except for its ok
};

}  // namespace lamina
