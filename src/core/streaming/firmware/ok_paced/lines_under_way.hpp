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
  std::uint64_t line = 0;      ///< of the program; 0 for any other command
  std::uint64_t question = 0;  ///< its identity; 0 if it is no question
  std::string change;          ///< that of a change of the job, as it is said; empty for any other command
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
  /// Number of lines of the program among them.
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
  /// The oldest line of the program; 0 if there is none.
  std::uint64_t oldestLine() const {
    const auto line = std::find_if(commands_.begin(), commands_.end(),
                                   [](const auto& command) { return command.line > 0; });
    return line == commands_.end() ? 0 : line->line;
  }
  /// Whether the next answer is that to a line of the program.
  bool isLineNext() const { return !commands_.empty() && commands_.front().line > 0; }
  /// The change to which the next answer belongs; empty if it belongs to anything else.
  std::string changeNext() const { return commands_.empty() ? std::string() : commands_.front().change; }

  /// Removes the oldest one, which was answered.
  std::optional<PacedCommand> takeOldest() {
    if (commands_.empty()) return std::nullopt;
    const PacedCommand oldest = commands_.front();
    commands_.pop_front();
    return oldest;
  }
  /// Removes the oldest line of the program, and whatever was sent before it; nothing if there is no line.
  std::optional<PacedCommand> takeOldestLine() {
    if (lines() == 0) return std::nullopt;
    while (!isLineNext()) commands_.pop_front();
    return takeOldest();
  }
  /// Whether a question is under way; its answer shows that all before it were read, if nothing is lost.
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
