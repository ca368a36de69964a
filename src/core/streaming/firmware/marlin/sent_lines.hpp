// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace lamina {

/// A line that was sent and is not yet answered.
struct SentLine {
  std::uint64_t number = 0;
  std::size_t bytes = 0;
  bool is_blocking = false;  ///< may take the machine long
  bool is_resent = false;    ///< was sent before
  /// Sent after a lost line: it is refused, or was discarded without an answer.
  bool is_stale = false;
};

/// Lines sent and not yet answered, oldest first. The firmware answers each line that it reads once, in
/// order, by an ok or by a request to resend. Since answers get lost and lines are discarded, each answer is
/// matched to the line that explains it best. A wrong match costs time but never a line, since the firmware
/// counts lines.
class SentLines {
 public:
  void add(const SentLine& line);
  void clear();

  bool empty() const { return lines_.empty(); }
  std::size_t count() const { return lines_.size(); }
  std::size_t bytes() const { return bytes_; }
  bool hasBlocking() const;

  bool hasStale() const;

  /// Counts an ok: the oldest line is done.
  /// @return its number; nothing if that line was stale, or there is none
  std::optional<std::uint64_t> acknowledge();
  /// Counts an ok with a number: every line up to this one is done.
  void acknowledgeUpTo(std::uint64_t number);

  /// Counts a repeated request as the refusal of the first stale line.
  /// @return false if no line is stale
  bool absorbRefusal();
  /// Evaluates a request for line `wanted`: the firmware has accepted all lines before it; the lines sent
  /// from `wanted` on are stale.
  void refuse(std::uint64_t wanted);
  /// Removes the stale lines, to which no answer will come.
  void dropStale();

 private:
  void popFront();

  std::deque<SentLine> lines_;
  std::size_t bytes_ = 0;
};

}  // namespace lamina
