// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace lamina {

/// Times the wait for answers of the firmware: when to repeat a question, at growing intervals, and how long
/// the firmware has been silent.
class AnswerTimer {
 public:
  /// @param first_retry_s  time until the first repetition
  explicit AnswerTimer(double first_retry_s) : first_retry_s_(first_retry_s), retry_s_(first_retry_s) {}

  /// Starts anew: an answer has arrived, or a wait begins.
  void restart(double now) {
    quiet_since_ = now;
    retry_s_ = first_retry_s_;
    retry_at_ = now + retry_s_;
  }

  /// States that the question was repeated.
  void asked(double now) {
    constexpr double kLongestRetry = 30.0;
    retry_s_ = std::min(2.0 * retry_s_, std::max(kLongestRetry, first_retry_s_));
    retry_at_ = now + retry_s_;
  }

  /// Sets the latest time of the next repetition.
  void askBy(double time_s) { retry_at_ = std::min(retry_at_, time_s); }

  double quietFor(double now) const { return now - quiet_since_; }
  double quietSince() const { return quiet_since_; }
  double retryAt() const { return retry_at_; }

 private:
  double first_retry_s_;
  double retry_s_;
  double quiet_since_ = 0.0;
  double retry_at_ = 0.0;
};

}  // namespace lamina
