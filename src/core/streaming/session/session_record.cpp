// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>

#include "streaming/session/session_kind.hpp"

namespace lamina {

void SessionRecord::publish(StreamStatus status, const std::vector<PackmlState>& entered, double now) {
  constexpr double kProgressInterval = 0.05;  // s
  if (entered.empty() && now < next_progress_) return;
  next_progress_ = now + kProgressInterval;
  if (status.failure.code != ErrorCode::Ok) status.failure.message = port_ + ": " + status.failure.message;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshot_ = status;
  }
  if (!observer_) return;
  for (std::size_t i = 0; i + 1 < entered.size(); ++i) {
    StreamStatus passing = status;
    passing.state = entered[i];
    observer_(passing);
  }
  observer_(status);
}

void SessionRecord::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_over_ = true;
  over_.notify_all();
}

StreamStatus SessionRecord::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return snapshot_;
}

bool SessionRecord::isOver() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_over_;
}

bool SessionRecord::waitFor(double timeout_s) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return over_.wait_for(lock, std::chrono::duration<double>(timeout_s), [this] { return is_over_; });
}

}  // namespace lamina
