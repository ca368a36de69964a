// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/cell/executor.hpp"
#include "messages.hpp"

namespace lamina {

/// What became of a change of the speed.
struct FeedAnswer {
  double feed = 1.0;
  std::string refusal;  ///< empty if it was taken
};

/// Where a job that was cut off would be resumed.
struct ResumeOutlook {
  bool is_by_place = false;      ///< it depends on where the machine stands
  bool is_place_proven = false;  ///< it stands where the job was cut off
  std::string text;
};

/// The node that runs a cell's jobs on its machine, as the cell sees it. Nothing waits for that node.
class MachineExecutor : public Executor {
 public:
  /// Name of the node, for people.
  virtual std::string name() const = 0;

  /// Has the job run at that part of its planned speed.
  virtual void changeFeed(double feed) = 0;
  /// What became of the last change of the speed, once.
  virtual std::optional<FeedAnswer> takeFeedAnswer() = 0;

  /// What the executor said last of a job that nobody here has started; nothing if it has said nothing.
  virtual std::optional<ExecutorReport> seen() const = 0;

  /// The last state of the machine.
  virtual const lamina_msgs::MachineState& machine() const = 0;

  /// Whether it gives signs of life, and would take a job.
  virtual bool isThere() const = 0;

  /// Looks, in a thread of its own, at where a job that was cut off would be resumed.
  virtual void lookAtResume(const std::string& /*program*/, const ExecutionProgress& /*progress*/) {}
  /// What that has shown; empty if nothing yet.
  virtual ResumeOutlook resumeOutlook() const { return {}; }

  /// Which order has waited that long for its answer, once; empty if none has. [s]
  virtual std::string takeUnanswered(double patience_s) = 0;
};

}  // namespace lamina
