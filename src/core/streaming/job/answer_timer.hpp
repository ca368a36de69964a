// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace lamina {

/// Waits for the firmware's answers: says when to ask again, ever more rarely, and how long it has been
/// quiet.
class AnswerTimer {
 public:
  /// @param first_retry_s  after which to ask for the first time
  explicit AnswerTimer(double first_retry_s) : first_retry_s_(first_retry_s), retry_s_(first_retry_s) {}

  /// An answer came, or something is waited for from now on.
  void restart(double now) {
    quiet_since_ = now;
    retry_s_ = first_retry_s_;
    retry_at_ = now + retry_s_;
  }

  /// The question was put again.
  void asked(double now) {
    constexpr double kLongestRetry = 30.0;
    retry_s_ = std::min(2.0 * retry_s_, std::max(kLongestRetry, first_retry_s_));
    retry_at_ = now + retry_s_;
  }

  /// The question is to be put again by then, or before.
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
