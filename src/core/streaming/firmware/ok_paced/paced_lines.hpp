// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "streaming/job/line_feed.hpp"
#include "streaming/job/revised_lines.hpp"

namespace lamina {

/// The lines of a program, with waits for the end of their motions: after the last line, and before a layer
/// that is not known yet.
class PacedLines {
 public:
  /// @param revised  null if the lines are sent unchanged
  PacedLines(const StreamableProgram& program, std::shared_ptr<RevisedLines> revised);

  /// Whether it is known which line comes next, or that there is none.
  bool isNextKnown();
  /// The next line; nothing at the end, or where the lines end early because the program's file was changed.
  std::optional<ProgramLine> next();

  /// Number of lines returned so far.
  std::uint64_t given() const { return given_; }
  /// Number of all lines except the wait after the last one, as of the last `count`.
  std::uint64_t total() const { return total_; }
  /// Counts the lines again: revision may change their number.
  void count();

 private:
  std::shared_ptr<RevisedLines> revised_;
  LineFeed::Source program_;
  std::uint64_t total_;
  std::uint64_t given_ = 0;
  std::uint64_t rests_ = 0;     ///< number of lines returned that only bring the machine to rest
  bool is_rest_given_ = false;  ///< whether the wait before the layer that is not known yet was returned
  std::int32_t layer_ = -1;     ///< layer of the line returned last
};

}  // namespace lamina
