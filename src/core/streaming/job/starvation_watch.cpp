// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/starvation_watch.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lamina {
namespace {

constexpr double kShortestTold = 0.05;  // s
// An answer that takes longer than this waited for room in the planner.
constexpr double kPrompt = 0.02;  // s
// Fewer than any planner holds, and more than planner, queue and window together.
constexpr std::size_t kFewestMotions = 8;
constexpr std::size_t kMostMotions = 24;
// Acceleration makes motions longer, hardly ever more than so.
constexpr double kSlowest = 1.5;

}  // namespace

void StarvationWatch::rewound(std::uint64_t line) {
  while (!under_way_.empty() && under_way_.back().number >= line) under_way_.pop_back();
}

void StarvationWatch::acknowledged(std::uint64_t line, std::optional<int> free_blocks, double now) {
  if (free_blocks) most_free_ = std::max(most_free_, *free_blocks);
  while (!under_way_.empty() && under_way_.front().number <= line) {
    take(under_way_.front(), free_blocks, now);
    under_way_.pop_front();
  }
}

void StarvationWatch::take(const Line& line, std::optional<int> free_blocks, double now) {
  if (line.waits) standStill();
  if (line.seconds > 0.0) {
    const double pause_s = is_moving_ ? pauseBefore(line, free_blocks, now) : 0.0;
    if (pause_s > kShortestTold) {
      ++starvation_.count;
      if (pause_s > starvation_.longest_s) {
        starvation_.longest_s = pause_s;
        starvation_.line = line.number;
      }
    }
    recent_.push_back(line.seconds);
    if (recent_.size() > kMostMotions) recent_.pop_front();
    runs_dry_at_ = std::max(runs_dry_at_, now) + line.seconds;
    const bool has_waited = now - line.sent_at > kPrompt;
    if (has_waited) runs_dry_at_ = std::max(runs_dry_at_, now + contentOf(kFewestMotions));
    is_moving_ = true;
  }
  taken_at_ = now;
}

/// How long the planner had been empty when the line came [s].
double StarvationWatch::pauseBefore(const Line& line, std::optional<int> free_blocks, double now) {
  // The line itself may be in the planner already.
  const bool was_empty = free_blocks && *free_blocks >= most_free_ - 1;
  const bool has_content = recent_.size() == kMostMotions;
  const double held_up_s = has_content ? now - taken_at_ - kSlowest * contentOf(kMostMotions) : 0.0;
  // An answer that was read late reports the time before: the next one shows whether the planner ran dry.
  const double held_up_before_s = std::exchange(held_up_s_, held_up_s);
  if (was_empty) return std::max({now - runs_dry_at_, held_up_s, held_up_before_s});
  if (free_blocks) return 0.0;
  const bool has_waited = now - line.sent_at > kPrompt;
  return has_waited ? held_up_s : std::max(now - runs_dry_at_, held_up_s);
}

/// Of the motions taken last [s].
double StarvationWatch::contentOf(std::size_t motions) const {
  const std::size_t count = std::min(motions, recent_.size());
  return std::accumulate(recent_.end() - static_cast<std::ptrdiff_t>(count), recent_.end(), 0.0);
}

}  // namespace lamina
