// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace lamina {

/// Commands that go out between the lines of a program, without a number of theirs: changes and questions of
/// others, and the wait for rest in front of a layer whose lines are not known yet.
class UnnumberedCommands {
 public:
  bool empty() const { return commands_.empty(); }
  const std::string& front() const { return commands_.front(); }
  void add(std::string command) { commands_.push_back(std::move(command)); }

  /// Adds a question. Questions wait for nobody: more than a few would stop the lines.
  /// @return whether it was added
  bool addQuestion(const std::string& question) {
    constexpr std::size_t kMostWaiting = 16;
    if (commands_.size() >= kMostWaiting) return false;
    add(question);
    return true;
  }
  /// Adds a wait for rest, once until a line is sent.
  /// @return whether it was added
  bool addRest(const std::string& command) {
    if (std::exchange(is_rest_added_, true)) return false;
    add(command);
    return true;
  }
  void lineSent() { is_rest_added_ = false; }

  /// States that the first one was answered.
  void answered() { commands_.pop_front(); }
  /// States that the first one has no answer. None of them is sent any more.
  /// @return what is to be said of it
  std::string lose() {
    const std::string lost = commands_.front();
    commands_.clear();
    return "no answer to " + lost + ", which may not have been done";
  }

 private:
  std::deque<std::string> commands_;
  bool is_rest_added_ = false;
};

}  // namespace lamina
