// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace lamina {

/// A command that was sent and is not yet answered.
struct PacedCommand {
  std::uint64_t line = 0;      ///< line number of the program; 0 for any other command
  std::uint64_t question = 0;  ///< number of the question; 0 if it is none
  std::string change;          ///< command of a change to the job; empty for any other command
  std::size_t bytes = 0;
  bool is_blocking = false;  ///< may take the machine long
};

/// Commands sent and not yet answered, oldest first, for firmware that answers in order.
class LinesUnderWay {
 public:
  void add(const PacedCommand& command) { commands_.push_back(command); }
  void clear() { commands_.clear(); }

  bool empty() const { return commands_.empty(); }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const PacedCommand& command : commands_) sum += command.bytes;
    return sum;
  }
  /// Number of program lines among the commands.
  std::size_t lines() const {
    return static_cast<std::size_t>(std::count_if(commands_.begin(), commands_.end(),
                                                  [](const auto& command) { return command.line > 0; }));
  }
  bool hasOthers() const { return lines() < commands_.size(); }
  bool hasChange() const {
    return std::any_of(commands_.begin(), commands_.end(),
                       [](const auto& command) { return !command.change.empty(); });
  }
  bool hasBlocking() const {
    return std::any_of(commands_.begin(), commands_.end(),
                       [](const auto& command) { return command.is_blocking; });
  }
  /// Number of the oldest program line; 0 if there is none.
  std::uint64_t oldestLine() const {
    const auto line = std::find_if(commands_.begin(), commands_.end(),
                                   [](const auto& command) { return command.line > 0; });
    return line == commands_.end() ? 0 : line->line;
  }
  /// Whether the next answer belongs to a program line.
  bool isLineNext() const { return !commands_.empty() && commands_.front().line > 0; }
  /// The change to which the next answer belongs; empty if it belongs to anything else.
  std::string changeNext() const { return commands_.empty() ? std::string() : commands_.front().change; }

  /// Removes and returns the oldest command, which was answered.
  std::optional<PacedCommand> takeOldest() {
    if (commands_.empty()) return std::nullopt;
    const PacedCommand oldest = commands_.front();
    commands_.pop_front();
    return oldest;
  }
  /// Removes the oldest program line and all commands sent before it, and returns the line; nothing if there
  /// is no line.
  std::optional<PacedCommand> takeOldestLine() {
    if (lines() == 0) return std::nullopt;
    while (!isLineNext()) commands_.pop_front();
    return takeOldest();
  }
  /// Whether a question is not answered yet. Its answer shows that all commands before it were read, if
  /// nothing is lost.
  bool hasQuestion(std::uint64_t question) const {
    return std::any_of(commands_.begin(), commands_.end(),
                       [question](const auto& command) { return command.question == question; });
  }
  bool isNext(std::uint64_t question) const {
    return !commands_.empty() && commands_.front().question == question;
  }

 private:
  std::deque<PacedCommand> commands_;
};

}  // namespace lamina
