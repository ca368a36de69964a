// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/cell/executor.hpp"
#include "messages.hpp"

namespace lamina {

/// Outcome of a change of the speed.
struct FeedAnswer {
  double feed = 1.0;
  std::string refusal;  ///< empty if it was taken
};

/// Where an interrupted job would be resumed.
struct ResumeOutlook {
  bool is_by_place = false;  ///< whether that depends on where the machine stands
  std::string text;          ///< the place, for people
  /// Length of beads after which it begins, where that depends on where the machine stands [mm].
  std::optional<double> begin_mm = {};
};

/// The node that runs a cell's jobs on its machine, as the cell sees it. No call waits for the node.
class MachineExecutor : public Executor {
 public:
  /// Name of the node, for messages.
  virtual std::string name() const = 0;

  /// Requests that the job run at that fraction of its planned speed.
  virtual void changeFeed(double feed) = 0;
  /// The outcome of the last change of the speed; returned once.
  virtual std::optional<FeedAnswer> takeFeedAnswer() = 0;

  /// The executor's last report on a job that was not started here; nothing if there is none.
  virtual std::optional<ExecutorReport> seen() const = 0;

  /// The last state of the machine.
  virtual const lamina_msgs::MachineState& machine() const = 0;

  /// Whether the node gives signs of life, and would take a job.
  virtual bool isThere() const = 0;

  /// Requests, in a thread of its own, where an interrupted job would be resumed.
  virtual void lookAtResume(const std::string& /*program*/, const ExecutionProgress& /*progress*/) {}
  /// The last answer to `lookAtResume`; empty if there is none yet.
  virtual ResumeOutlook resumeOutlook() const { return {}; }

  /// States where a person has confirmed that the job begins that is to be resumed next, as
  /// `ResumeOutlook::begin_mm`; nothing for the last outlook. An executor that would begin elsewhere refuses.
  virtual void confirmPlace(std::optional<double> /*begin_mm*/) {}

  /// The order that has waited for its answer for `patience_s` [s]; returned once, empty if there is none.
  virtual std::string takeUnanswered(double patience_s) = 0;
};

}  // namespace lamina
