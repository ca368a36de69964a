// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "machine_executor.hpp"

namespace lamina {

/// What the node of a robot says of a resume.
struct ResumeAnswer {
  std::string refusal;  ///< why it is refused; empty if it is not
  ResumeOutlook outlook;
};

/// Where a job that was cut off is resumed, by what the robot's node has answered. Its calls may come from
/// several threads.
class ResumeLook {
 public:
  /// @param unanswered  the refusal as long as there is no answer
  explicit ResumeLook(std::string unanswered);

  /// Whether a job is resumed on its bead: of which nothing was handed over, nothing is laid, and it begins
  /// anew.
  static bool isOnItsBead(const ExecutionProgress& progress) { return progress.sent_through > 0; }

  /// The job that is looked at from now on.
  /// @return its name for `answer`, if the node is to be asked; nothing while another answer is awaited
  std::optional<std::string> lookAt(const std::string& program, const ExecutionProgress& progress);
  /// One to a job that was looked at before is dropped.
  void answer(const std::string& job, ResumeAnswer answer);

  std::string refusal() const;
  ResumeOutlook outlook() const;

 private:
  const std::string unanswered_;
  mutable std::mutex mutex_;  ///< of what follows
  ResumeAnswer known_;
  std::string job_;        ///< program and progress that it is about
  bool is_asked_ = false;  ///< and not answered
};

}  // namespace lamina
