// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/starvation_watch.hpp"

#include <algorithm>
#include <numeric>

namespace lamina {
namespace {

constexpr double kShortestTold = 0.05;  // s
// An answer that takes longer than this waited for room in the planner.
constexpr double kPrompt = 0.02;  // s
// Fewer than any planner holds.
constexpr std::size_t kPlannerMotions = 8;

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
  if (line.seconds <= 0.0) return;
  recent_.push_back(line.seconds);
  if (recent_.size() > kPlannerMotions) recent_.pop_front();
  const bool has_waited = now - line.sent_at > kPrompt;
  if (is_moving_ && isEmpty(free_blocks, now) && !(has_waited && !free_blocks)) {
    const double pause_s = now - runs_dry_at_;
    ++starvation_.count;
    if (pause_s > starvation_.longest_s) {
      starvation_.longest_s = pause_s;
      starvation_.line = line.number;
    }
  }
  runs_dry_at_ = std::max(runs_dry_at_, now) + line.seconds;
  if (has_waited) runs_dry_at_ = std::max(runs_dry_at_, now + shortestContent());
  is_moving_ = true;
}

/// Whether the planner was empty for long when the line came.
bool StarvationWatch::isEmpty(std::optional<int> free_blocks, double now) {
  if (now - runs_dry_at_ < kShortestTold) return false;
  // The line itself may be in the planner already.
  return !free_blocks || *free_blocks >= most_free_ - 1;
}

double StarvationWatch::shortestContent() const {
  return std::accumulate(recent_.begin(), recent_.end(), 0.0);
}

}  // namespace lamina
