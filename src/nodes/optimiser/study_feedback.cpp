// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study_feedback.hpp"

namespace lamina {

void StudyFeedback::report(const std::string& stage, double fraction) {
  constexpr std::chrono::milliseconds kPeriod(50);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_report_ < kPeriod) return;
  last_report_ = now;
  feedback_.stage = stage;
  feedback_.fraction = static_cast<float>(fraction);
  server_.publishFeedback(feedback_);
}

void StudyFeedback::send(const StudyState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  feedback_.generation = static_cast<std::uint32_t>(state.index);
  feedback_.evaluations = static_cast<std::uint32_t>(state.evaluations);
  feedback_.failed = static_cast<std::uint32_t>(state.failed);
  feedback_.best = state.best;
  feedback_.hypervolume = state.hypervolume;
  server_.publishFeedback(feedback_);
}

}  // namespace lamina
