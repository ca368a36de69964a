// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "lamina/startup/job_watch.hpp"
#include "lamina/startup/startup.hpp"
#include "lamina/streaming/session/stream_session.hpp"

namespace lamina {

/// A machine's start-up at its port, in a thread of its own: runs steps, looks at the machine from time to
/// time while something it was made to do lasts, and lends the port to jobs. All calls may come from any
/// thread. Without a sequence it does nothing and lets every job start.
///
/// A sequence that is aborted, a bed that does not heat as it should and a machine that stops answering end
/// with `startup.abort_code`, as does the session itself if the machine was made to do anything.
class StartupSession {
 public:
  /// Given the steps when they may have changed; from any thread, also before the constructor has returned.
  using Observer = std::function<void(const std::vector<StartupStatus>&)>;

  /// @throws InvalidConfig as `makeStartupSequence`, or if a code of the settings cannot be streamed
  StartupSession(const StartupSettings& settings, const StreamSettings& stream, const MachinePort& port,
                 Observer changed);
  ~StartupSession();
  StartupSession(const StartupSession&) = delete;
  StartupSession& operator=(const StartupSession&) = delete;

  bool isEmpty() const;
  std::vector<StartupStatus> steps() const;
  /// Whether the step is in the sequence and not left out.
  bool awaits(StartupStep step) const;

  /// Begins a step, or without one all that can be run without the operator, in order; returns at once.
  /// @throws InvalidInput, Rejected as `Startup::begin`; Rejected if a job or another step is under way, or
  /// nothing can be run
  void run(std::optional<StartupStep> step);
  /// @throws InvalidInput, Rejected as `Startup::confirm`; Rejected if a job is under way
  void confirm(StartupStep step);
  /// @throws InvalidInput, Rejected as `Startup::transferred`; Rejected if a job is under way
  void transferred(const ProgramIdentity& program);
  /// Stops what is running and leaves the machine safe; returns at once.
  /// @throws Rejected if a job is under way
  void abort();
  /// Whether a step is being run or the machine is being left safe.
  bool isBusy() const;

  /// Looks at the machine and lends it to a job until `endJob`.
  /// @throws Rejected naming the first step that is not satisfied, and its reason; if a step is under way
  /// @throws DeviceError if the machine cannot be reached
  void beginJob(const ProgramIdentity& program);
  /// The program that the job has begun to send. Of one whose lines are changed on their way, its commands
  /// count as sent somewhat early.
  void watchJob(const StreamableProgram& program, WatchedLines lines);
  /// What the machine has lost of its start-up since, and the program has not ended (`JobWatch`); empty
  /// without a sequence.
  std::vector<JobLoss> losses(const StreamStatus& status);
  /// What to ask the machine during a job, one command on each line: what it does not report by itself of the
  /// steps of the sequence. Empty for nothing.
  std::string questions() const;
  /// What the machine says during the job.
  void heard(const FirmwareReply& reply);
  /// The job is over: what it has switched off is lost.
  void endJob(const StreamableProgram& program, const StreamStatus& status);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
