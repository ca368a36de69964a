// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// Phase of an executor.
enum class ExecutorPhase : std::uint8_t {
  Resting,  ///< no job, or one that was stopped or aborted
  Starting,
  Running,
  Pausing,
  Paused,
  Resuming,
  Stopping,
  Done,  ///< the job was completed
};

/// Whether no job is under way.
inline bool isAtRest(ExecutorPhase phase) {
  return phase == ExecutorPhase::Resting || phase == ExecutorPhase::Done;
}

/// What was taken or laid is not taken back. What is not known any more (NaN) counts as not measured: 0.
inline ExecutionProgress furthest(const ExecutionProgress& before, ExecutionProgress now) {
  if (now.taken_through < before.taken_through) {
    now.taken_through = before.taken_through;
    now.layer = before.layer;
  }
  now.sent_through = std::max(now.sent_through, before.sent_through);
  now.path_mm = std::isfinite(now.path_mm) ? std::max(now.path_mm, before.path_mm) : 0.0;
  now.deposited_mm3 =
      std::isfinite(now.deposited_mm3) ? std::max(now.deposited_mm3, before.deposited_mm3) : 0.0;
  return now;
}

/// How an executor begins a job.
enum class ExecutionStart : std::uint8_t {
  Anew,
  Resume,         ///< the machine has accepted lines of it: the job is continued, or refused
  ResumeIfBegun,  ///< unknown here whether a line was sent: continued if so, otherwise begun
};

/// The order to start a job.
struct StartOrder {
  std::string program;
  ExecutionStart start = ExecutionStart::Anew;
  /// Number of the order, from 1, which the executor's reports repeat.
  std::uint64_t order = 0;
  /// Name of this execution of the job, unique across all journals.
  std::string execution;
  /// What was reported of an execution that was cut off; nothing of one that begins.
  ExecutionProgress progress = {};
};

/// The last report of an executor.
struct ExecutorReport {
  ExecutorPhase phase = ExecutorPhase::Resting;
  /// Number of the order reported on; 0 for a job that was not ordered by this cell.
  std::uint64_t order = 0;
  std::string program;      ///< path of the job's program
  std::uint64_t lines = 0;  ///< number of lines of the program that carry a command
  ExecutionProgress progress;
  int alarm = 0;        ///< ID of the alarm that ended the job; 0 if none did, or it has not ended
  std::string failure;  ///< that alarm in a sentence
  /// Whether the executor has ended the job by stopping its machine, so that motions are lost that the
  /// machine had accepted: such a job cannot be resumed.
  bool has_lost_motions = false;
};

/// Texts about an executor, and what it cannot do.
struct ExecutorTraits {
  std::string unit = "line";  ///< unit of a job's file in which progress is counted
  /// Why the executor cannot resume jobs that were cut off; empty if it can.
  std::string against_resuming = {};
};

/// Runs jobs on the machine by orders of the cell. Orders return at once; their effect is reported later.
class Executor {
 public:
  virtual ~Executor() = default;
  virtual ExecutorTraits traits() const { return {}; }
  /// Starts a job. If its execution is complete by the executor's own record, it is reported as done.
  virtual void start(const StartOrder& order) = 0;
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// Ends the job in a controlled way; the machine is left as its settings say.
  virtual void stop() = 0;
  /// Ends the job as fast as the executor can.
  virtual void abort() = 0;
};

}  // namespace lamina
