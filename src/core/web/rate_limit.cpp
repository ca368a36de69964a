// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/rate_limit.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr std::size_t kMostSources = 1024;

}  // namespace

double RateLimit::takenOf(const std::string& source, double now_s) const {
  const auto found = taken_.find(source);
  if (found == taken_.end()) return 0.0;
  return std::max(0.0, found->second.amount - (now_s - found->second.at_s) * rate_.per_second);
}

bool RateLimit::hasLeft(const std::string& source, double now_s) const {
  return takenOf(source, now_s) + 1.0 <= rate_.burst;
}

bool RateLimit::take(const std::string& source, double now_s) {
  if (!hasLeft(source, now_s)) return false;
  const double taken = takenOf(source, now_s) + 1.0;
  forgetOld(now_s);
  taken_[source] = {taken, now_s};
  return true;
}

void RateLimit::forgetOld(double now_s) {
  if (taken_.size() < kMostSources) return;
  for (auto entry = taken_.begin(); entry != taken_.end();)
    entry = takenOf(entry->first, now_s) <= 0.0 ? taken_.erase(entry) : std::next(entry);
  // All of them are at it: the one that came last longest ago has the most to gain, and the least to spare.
  if (taken_.size() >= kMostSources)
    taken_.erase(std::min_element(taken_.begin(), taken_.end(), [](const auto& one, const auto& other) {
      return one.second.at_s < other.second.at_s;
    }));
}

}  // namespace lamina
