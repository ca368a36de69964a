// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "streaming/job/line_feed.hpp"
#include "streaming/job/revised_lines.hpp"

namespace lamina {

/// The lines of a program, and the waits for the end of their motions: behind the last line, and in front of
/// a layer that is not known yet.
class PacedLines {
 public:
  /// @param revised  null if the lines go as they are
  PacedLines(const StreamableProgram& program, std::shared_ptr<RevisedLines> revised);

  /// Whether it is known which line comes next, or that there is none.
  bool isNextKnown();
  /// The next line; nothing at the end, or where a program ends that was changed.
  std::optional<ProgramLine> next();

  /// Lines given so far.
  std::uint64_t given() const { return given_; }
  /// All lines but the wait behind the last one, as they were counted last.
  std::uint64_t total() const { return total_; }
  /// Counts them anew: lines that are revised become more or fewer.
  void count();

 private:
  std::shared_ptr<RevisedLines> revised_;
  LineFeed::Source program_;
  std::uint64_t total_;
  std::uint64_t given_ = 0;
  std::uint64_t rests_ = 0;     ///< lines given that only bring the machine to rest
  bool is_rest_given_ = false;  ///< in front of the layer that is not known yet
  std::int32_t layer_ = -1;     ///< of the line given last
};

}  // namespace lamina
