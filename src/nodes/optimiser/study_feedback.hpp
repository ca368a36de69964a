// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>

#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/study/study_job.hpp"
#include "messages.hpp"
#include "progress/action_progress.hpp"

namespace lamina {

/// Reports the progress of a study to a client: the stage, and the findings of the last generation or
/// iteration. Cancelled as `ActionProgress` is.
class StudyFeedback final : public Progress {
 public:
  using Server = actionlib::SimpleActionServer<lamina_msgs::OptimiseAction>;

  /// @param server  must outlive this
  explicit StudyFeedback(Server& server) : server_(server), cancelling_(server) {}

  void report(const std::string& stage, double fraction) override;
  bool isCancelled() const override { return cancelling_.isCancelled(); }

  /// Publishes in any case, however recent the last feedback.
  void send(const StudyState& state);

 private:
  Server& server_;
  ActionProgress<lamina_msgs::OptimiseAction> cancelling_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point last_report_;
  lamina_msgs::OptimiseFeedback feedback_;
};

}  // namespace lamina
