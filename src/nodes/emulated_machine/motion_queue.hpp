// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "lamina/streaming/emulator/emulated_motion.hpp"

namespace lamina {

/// Hands motions from the emulator's thread to the one that deposits and publishes. A full queue holds the
/// machine up: memory stays bounded.
class MotionQueue {
 public:
  void push(const ExecutedMotion& motion) {
    constexpr std::size_t kCapacity = 4096;
    std::unique_lock<std::mutex> lock(mutex_);
    has_room_.wait(lock, [this] { return is_closed_ || motions_.size() < kCapacity; });
    if (is_closed_) return;
    motions_.push_back(motion);
    has_motion_.notify_one();
  }

  /// The next motion; nothing after `timeout` without one, or once the queue is closed. The previously popped
  /// motion then counts as done.
  std::optional<ExecutedMotion> pop(std::chrono::milliseconds timeout) {
    std::unique_lock<std::mutex> lock(mutex_);
    is_taken_ = false;
    has_motion_.wait_for(lock, timeout, [this] { return is_closed_ || !motions_.empty(); });
    if (is_closed_ || motions_.empty()) return std::nullopt;
    const ExecutedMotion motion = motions_.front();
    motions_.pop_front();
    is_taken_ = true;
    has_room_.notify_one();
    return motion;
  }

  /// Whether no motion waits, and the last popped motion is done.
  bool isAtRest() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return motions_.empty() && !is_taken_;
  }

  /// Ends all waits.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_closed_ = true;
    has_room_.notify_all();
    has_motion_.notify_all();
  }
  bool isClosed() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_closed_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable has_room_;
  std::condition_variable has_motion_;
  std::deque<ExecutedMotion> motions_;
  bool is_taken_ = false;  ///< whether a popped motion is not done yet
  bool is_closed_ = false;
};

}  // namespace lamina
