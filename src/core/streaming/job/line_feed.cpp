// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/line_feed.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "streaming/job/motion_time.hpp"
#include "streaming/job/read_ahead.hpp"

namespace lamina {
namespace {

// Far more than any window: firmware asks for lines it has just missed.
constexpr std::size_t kRememberedLines = 1024;

}  // namespace

LineFeed::Source sourceOf(const StreamableProgram& program) {
  if (program.isHeld()) {
    return [cursor = std::make_shared<ProgramCursor>(program.open()),
            time = std::make_shared<MotionTime>()]() -> std::optional<ProgramLine> {
      auto line = cursor->next();
      if (line) line->seconds = time->secondsOf(line->command);
      return line;
    };
  }
  return [ahead = std::make_shared<ReadAhead>(program)] { return ahead->next(); };
}

LineFeed::Source restOf(const StreamableProgram& program, std::uint64_t lines_left_out,
                        const std::function<void(const ProgramLine&)>& passed) {
  LineFeed::Source source = sourceOf(program);
  for (std::uint64_t i = 0; i < lines_left_out; ++i)
    if (const auto line = source()) passed(*line);
  return source;
}

LineFeed::Source sourceOf(std::vector<std::string> commands) {
  std::reverse(commands.begin(), commands.end());
  return [left = std::move(commands)]() mutable -> std::optional<ProgramLine> {
    if (left.empty()) return std::nullopt;
    ProgramLine line{left.back(), -1, 0.0};
    left.pop_back();
    return line;
  };
}

const ProgramLine* LineFeed::peek() {
  const std::size_t index = next_ - first_kept_;
  if (index < kept_.size()) return &kept_[index];
  auto line = source_();
  if (!line) return nullptr;
  kept_.push_back(std::move(*line));
  has_unsent_ = true;
  return &kept_.back();
}

void LineFeed::advance() {
  if (next_ == end()) has_unsent_ = false;
  ++next_;
  if (kept_.size() <= kRememberedLines) return;
  kept_.pop_front();
  ++first_kept_;
}

bool LineFeed::rewind(std::uint64_t number) {
  if (number < first_kept_ || number > end()) return false;
  next_ = number;
  return true;
}

std::int32_t LineFeed::layerOf(std::uint64_t number) const {
  if (number == line_before_) return layer_before_;
  if (number < first_kept_ || number >= first_kept_ + kept_.size()) return -1;
  return kept_[number - first_kept_].layer;
}

}  // namespace lamina
