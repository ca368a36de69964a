// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/time_left.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kWindow = 300.0;   // [s]
constexpr double kSampled = 2.0;    // [s]
constexpr double kLeastTime = 5.0;  // [s]
constexpr double kLeastPart = 0.01;
constexpr double kUncertainty = 0.1;
constexpr double kWarmingUp = 2.0;  // [s]: what this is of the time gone adds to the uncertainty

}  // namespace

void TimeLeft::observe(double now_s, long long job, double fraction) {
  if (job != job_) {
    *this = TimeLeft();
    job_ = job;
    first_fraction_ = fraction;
  }
  if (last_s_) running_s_ += std::max(0.0, now_s - *last_s_);
  last_s_ = now_s;
  if (!recent_.empty() && running_s_ - recent_.back().running_s < kSampled) return;
  recent_.push_back({running_s_, fraction});
  while (running_s_ - recent_.front().running_s > kWindow) recent_.pop_front();
}

void TimeLeft::pause(double now_s) {
  if (last_s_) last_s_ = now_s;
}

std::optional<LeftEstimate> TimeLeft::estimate() const {
  if (recent_.size() < 2 || recent_.back().running_s < kLeastTime) return std::nullopt;
  const Sample& last = recent_.back();
  const double gone = last.fraction - first_fraction_;
  const double lately = last.fraction - recent_.front().fraction;
  if (gone < kLeastPart || lately <= 0.0) return std::nullopt;
  const double left = 1.0 - last.fraction;
  const double by_all_s = left * last.running_s / gone;
  const double by_last_s = left * (last.running_s - recent_.front().running_s) / lately;
  const auto [least_s, most_s] = std::minmax(by_all_s, by_last_s);
  const double uncertainty = kUncertainty + kWarmingUp / last.running_s;
  return LeftEstimate{(by_all_s + by_last_s) / 2.0, least_s * (1.0 - uncertainty),
                      most_s * (1.0 + uncertainty)};
}

}  // namespace lamina
