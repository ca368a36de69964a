// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/sent_lines.hpp"

#include <algorithm>

namespace lamina {

void SentLines::add(const SentLine& line) {
  lines_.push_back(line);
  bytes_ += line.bytes;
}

void SentLines::clear() {
  lines_.clear();
  bytes_ = 0;
}

void SentLines::popFront() {
  bytes_ -= lines_.front().bytes;
  lines_.pop_front();
}

bool SentLines::hasBlocking() const {
  return std::any_of(lines_.begin(), lines_.end(), [](const SentLine& line) { return line.is_blocking; });
}

bool SentLines::hasStale() const {
  return std::any_of(lines_.begin(), lines_.end(), [](const SentLine& line) { return line.is_stale; });
}

std::optional<std::uint64_t> SentLines::acknowledge() {
  if (lines_.empty()) return std::nullopt;
  const SentLine done = lines_.front();
  popFront();
  return done.is_stale ? std::nullopt : std::optional<std::uint64_t>(done.number);
}

void SentLines::acknowledgeUpTo(std::uint64_t number) {
  while (!lines_.empty() && (lines_.front().is_stale || lines_.front().number <= number)) popFront();
}

bool SentLines::absorbRefusal() {
  const auto stale =
      std::find_if(lines_.begin(), lines_.end(), [](const SentLine& line) { return line.is_stale; });
  if (stale == lines_.end()) return false;
  bytes_ -= stale->bytes;
  lines_.erase(stale);
  return true;
}

void SentLines::refuse(std::uint64_t wanted) {
  for (SentLine& line : lines_) {
    // A first copy before the wanted line was taken and its ok is still to come; any other line will be
    // refused.
    if (line.is_resent || line.number >= wanted) line.is_stale = true;
  }
  absorbRefusal();
}

void SentLines::dropStale() {
  while (absorbRefusal()) {
  }
}

}  // namespace lamina
