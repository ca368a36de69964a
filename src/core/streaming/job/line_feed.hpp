// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Numbers the lines of a program and keeps the last ones sent, so that they can be sent again.
class LineFeed {
 public:
  using Source = std::function<std::optional<ProgramLine>()>;
  /// Function that returns whether the source knows its next line.
  using Readiness = std::function<bool()>;

  /// @param first         number of the first line
  /// @param layer_before  layer of the line before; -1 if there is none
  /// @param isReady       empty if the next line is always known
  LineFeed(Source source, std::uint64_t first, std::int32_t layer_before = -1, Readiness isReady = {})
      : source_(std::move(source)),
        isReady_(std::move(isReady)),
        line_before_(first - 1),
        layer_before_(layer_before),
        first_kept_(first),
        next_(first) {}

  /// Whether it is known which line is sent next, or that there is none.
  bool isNextKnown() const { return next_ - first_kept_ < kept_.size() || !isReady_ || isReady_(); }
  /// The line to send next; null at the end of the program.
  const ProgramLine* peek();
  /// States that the line of `peek` was sent.
  void advance();
  /// Sends again from line `number` on.
  /// @return false, without effect, if that line was never sent or is no longer kept
  bool rewind(std::uint64_t number);

  /// Number of the line of `peek`.
  std::uint64_t next() const { return next_; }
  /// One more than the highest number sent.
  std::uint64_t end() const { return first_kept_ + kept_.size() - (has_unsent_ ? 1 : 0); }
  /// Layer of a line that is kept, or of the line before the first; -1 otherwise.
  std::int32_t layerOf(std::uint64_t number) const;

 private:
  Source source_;
  Readiness isReady_;
  std::uint64_t line_before_;  ///< number of the line before the first one
  std::int32_t layer_before_;
  std::deque<ProgramLine> kept_;  ///< lines first_kept_ and following
  bool has_unsent_ = false;       ///< whether the last line kept was read but never sent
  std::uint64_t first_kept_;
  std::uint64_t next_;
};

/// Longest wait for the next line of a program [s]; sleeping disks need ten.
inline constexpr double kLongestRead = 30.0;

/// The lines of a source, read a thousand ahead in a separate thread: a slow disk or network folder does not
/// stop the machine. They end early if the source has changed, since its new content was not checked, and if
/// the next line does not come within the patience: a machine is stopped without the disk.
/// @param source, hasChanged  called in that thread, which outlives the lines while such a call lasts
/// @param patience_s  longest wait for the next line
LineFeed::Source readAhead(LineFeed::Source source, std::function<bool()> hasChanged, double patience_s);

/// The lines of a program. They end early if its file changes meanwhile, or cannot be read for
/// `kLongestRead`.
LineFeed::Source sourceOf(const StreamableProgram& program);

/// The lines of a program without its first ones; each line left out is passed to `passed`.
LineFeed::Source restOf(const StreamableProgram& program, std::uint64_t lines_left_out,
                        const std::function<void(const ProgramLine&)>& passed);

/// Single commands, in order.
LineFeed::Source sourceOf(std::vector<std::string> commands);

}  // namespace lamina
