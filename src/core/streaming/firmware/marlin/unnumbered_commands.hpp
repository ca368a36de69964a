// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

#include "streaming/job/change_commands.hpp"

namespace lamina {

/// Commands sent between the lines of a program, without line numbers: changes and questions from outside,
/// and the wait for rest before a layer whose lines are not known yet.
class UnnumberedCommands {
 public:
  bool empty() const { return commands_.empty(); }
  const std::string& front() const { return commands_.front().text; }
  void addChange(std::string command) { commands_.push_back({std::move(command), Kind::Change}); }

  /// Adds a question. More than a few are not accepted, as they would hold up the lines.
  /// @return whether it was added
  bool addQuestion(const std::string& question) {
    constexpr std::size_t kMostWaiting = 16;
    if (commands_.size() >= kMostWaiting) return false;
    commands_.push_back({question, Kind::Question});
    return true;
  }
  /// Adds a wait for rest, unless one was added since the last line was sent.
  /// @return whether it was added
  bool addRest(const std::string& command) {
    if (std::exchange(is_rest_added_, true)) return false;
    commands_.push_back({command, Kind::Rest});
    return true;
  }
  void lineSent() { is_rest_added_ = false; }

  /// States that the first command was answered.
  void answered() { commands_.pop_front(); }
  /// States that the first command will get no answer. The questions after it are dropped; a wait for rest
  /// may be added again.
  /// @return message on the command
  std::string lose() {
    const Command lost = commands_.front();
    commands_.pop_front();
    if (lost.kind == Kind::Rest) is_rest_added_ = false;
    commands_.erase(std::remove_if(commands_.begin(), commands_.end(),
                                   [](const Command& command) { return command.kind == Kind::Question; }),
                    commands_.end());
    return noAnswerTo(lost.text);
  }

 private:
  enum class Kind : std::uint8_t { Change, Question, Rest };
  struct Command {
    std::string text;
    Kind kind = Kind::Change;
  };

  std::deque<Command> commands_;
  bool is_rest_added_ = false;
};

}  // namespace lamina
