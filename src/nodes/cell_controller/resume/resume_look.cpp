// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "resume_look.hpp"

#include <utility>

#include "lamina/base/number_text.hpp"

namespace lamina {

ResumeLook::ResumeLook(std::string unanswered)
    : unanswered_(std::move(unanswered)), known_{unanswered_, {true, ""}} {}

std::optional<std::string> ResumeLook::lookAt(const std::string& program, const ExecutionProgress& progress) {
  const bool is_on_bead = isOnItsBead(progress);
  std::string job = program + ' ' + (is_on_bead ? numberText(progress.path_mm) : "anew");
  const std::lock_guard<std::mutex> lock(mutex_);
  if (job != job_) {
    known_ = {unanswered_, {true, ""}};
    job_ = std::move(job);
  }
  if (!is_on_bead) {
    known_ = {"", {true, "nothing of it was handed over, and nothing is laid: it begins anew, at its start"}};
    return std::nullopt;
  }
  if (std::exchange(is_asked_, true)) return std::nullopt;
  return job_;
}

void ResumeLook::answer(const std::string& job, ResumeAnswer answer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_asked_ = false;
  if (job == job_) known_ = std::move(answer);
}

std::string ResumeLook::refusal() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return known_.refusal;
}

ResumeOutlook ResumeLook::outlook() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return known_.outlook;
}

}  // namespace lamina
