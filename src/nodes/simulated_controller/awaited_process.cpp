// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "awaited_process.hpp"

#include <algorithm>

#include "stamps.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMost = 1000;  // that are kept: those of clients without counterparts

/// Drops a stamp and what came before it, which has no counterpart any more. Whether the stamp was there.
bool dropUpTo(std::deque<ros::Time>& stamps, const ros::Time& stamp) {
  const auto found = std::find(stamps.begin(), stamps.end(), stamp);
  if (found == stamps.end()) return false;
  stamps.erase(stamps.begin(), found + 1);
  return true;
}

void keep(std::deque<ros::Time>& stamps, const ros::Time& stamp) {
  stamps.push_back(stamp);
  if (stamps.size() > kMost) stamps.pop_front();
}

}  // namespace

void AwaitedProcess::hearGoal(const ros::Time& stamp) {
  if (dropUpTo(processes_, stamp)) return goals_.clear();
  const bool is_expected = !last_process_.isZero() && secondsBetween(last_process_, stamp) <= expected_s_;
  if (is_expected) keep(goals_, stamp);
}

void AwaitedProcess::hearProcess(const ros::Time& stamp) {
  last_process_ = stamp;
  if (dropUpTo(goals_, stamp)) return processes_.clear();
  keep(processes_, stamp);
}

std::optional<ros::Time> AwaitedProcess::first() const {
  if (goals_.empty()) return std::nullopt;
  return *std::min_element(goals_.begin(), goals_.end());
}

}  // namespace lamina
