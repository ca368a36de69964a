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
  bool is_stale = false;  ///< sent after one that was lost: it can only be refused, or was discarded unseen
};

/// Lines sent and not yet answered, oldest first. The firmware answers each line it reads once, in order, by
/// an ok or by a request to resend; but answers get lost and lines are discarded, so that each answer is
/// matched to the line that explains it best. What is matched wrongly costs time and never a line: the
/// firmware counts them.
class SentLines {
 public:
  void add(const SentLine& line);
  void clear();

  bool empty() const { return lines_.empty(); }
  std::size_t count() const { return lines_.size(); }
  std::size_t bytes() const { return bytes_; }
  bool hasBlocking() const;

  bool hasStale() const;

  /// An ok: the oldest line is done.
  /// @return its number; nothing if it was stale, or there is none
  std::optional<std::uint64_t> acknowledge();
  /// An ok with a number: every line up to that one is done.
  void acknowledgeUpTo(std::uint64_t number);

  /// A request that was heard before: the refusal of the first stale line.
  /// @return false if no line is stale
  bool absorbRefusal();
  /// The firmware has the lines before `wanted` and asks for that one: what was sent from there on has become
  /// stale.
  void refuse(std::uint64_t wanted);
  /// The stale lines were discarded unseen: no answer to them will come.
  void dropStale();

 private:
  void popFront();

  std::deque<SentLine> lines_;
  std::size_t bytes_ = 0;
};

}  // namespace lamina
