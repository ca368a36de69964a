// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_job.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/starvation_watch.hpp"
#include "streaming/job/undone_commands.hpp"

namespace lamina {

/// Accounts for a program's lines in the status of its job: lines that the machine has accepted, lines that
/// it did not do, and lines before which it stood still because they came late.
class LineAccount {
 public:
  /// @param line_base  number of the line before the program's first
  LineAccount(StreamStatus& status, std::uint64_t line_base) : status_(status), line_base_(line_base) {}
  LineAccount(const LineAccount&) = delete;  // it refers to the status of its job
  LineAccount& operator=(const LineAccount&) = delete;

  /// The watch that is told what is sent to the machine and when it stands still.
  StarvationWatch& starvation() { return starvation_; }

  /// States that a line and all before it were accepted.
  /// @param layer        layer of that line
  /// @param free_blocks  free blocks of the planner, if the firmware reports them
  void taken(std::uint64_t line, std::int32_t layer, std::optional<int> free_blocks, double now) {
    undone_.acknowledge(line);
    starvation_.acknowledged(line, free_blocks, now);
    status_.starvation = starvation_.starvation();
    takenUpTo(line, layer);
  }
  /// States that the lines from this one on are sent again.
  /// @param layer_before  layer of the line before
  void rewound(std::uint64_t line, std::int32_t layer_before) {
    undone_.rewind(line);
    starvation_.rewound(line);
    takenUpTo(line - 1, layer_before);
  }
  /// States that a line that was not accepted is sent again.
  void repeated(std::uint64_t line) { undone_.rewind(line); }
  /// States that the machine will not do the line that it acknowledges next.
  void notDone(const std::string& why) {
    if (undone_.count() == 0) status_.first_not_done = why;
    undone_.announce();
  }

 private:
  void takenUpTo(std::uint64_t line, std::int32_t layer) {
    status_.commands_not_done = undone_.count();
    status_.lines_acknowledged = line - line_base_;
    status_.layer = layer;
  }

  StreamStatus& status_;
  std::uint64_t line_base_;
  StarvationWatch starvation_;
  UndoneCommands undone_;
};

}  // namespace lamina
