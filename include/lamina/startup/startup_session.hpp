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

/// What a start-up session reports.
struct StartupReport {
  std::vector<StartupStatus> steps;  ///< in the order of the sequence
  /// Whether a heater that a step has switched on may still be on; independent of the states of the steps.
  bool may_be_on = false;
};

/// Runs a machine's start-up sequence at its port, in a thread of its own. It runs steps, checks the machine
/// periodically as long as a step that it runs or reports is running or done, or something may still be on,
/// and lends the port to jobs. All functions may be called from any thread. Without a sequence it does
/// nothing and lets every job start.
///
/// It sends `startup.abort_code` if the sequence is aborted, the bed does not heat as it should, or the
/// machine stops answering; also when the session ends and a step has acted on the machine.
///
/// Once the code of a step was sent, something may be on, even after the step was lost, until the machine has
/// confirmed `startup.abort_code`, reports that it heats nothing, or has restarted or halted.
class StartupSession {
 public:
  /// Called with the report when it may have changed; from any thread, and possibly before the constructor
  /// has returned.
  using Observer = std::function<void(const StartupReport&)>;
  /// Whether a job is still to begin; called repeatedly, from the thread that requests the job.
  using MayGoOn = std::function<bool()>;

  /// @throws InvalidConfig as `makeStartupSequence`, or if a code of the settings cannot be streamed
  StartupSession(const StartupSettings& settings, const StreamSettings& stream, const MachinePort& port,
                 Observer changed);
  ~StartupSession();
  StartupSession(const StartupSession&) = delete;
  StartupSession& operator=(const StartupSession&) = delete;

  bool isEmpty() const;
  StartupReport report() const;
  std::vector<StartupStatus> steps() const { return report().steps; }
  /// Whether a step is in the sequence and not skipped.
  bool awaits(StartupStep step) const;

  /// Begins a step; if none is given, begins in order all steps that can be run without the operator. Returns
  /// at once.
  /// @throws InvalidInput, Rejected as `Startup::begin`; Rejected if a job or another step is under way, or
  ///   there is nothing to run
  void run(std::optional<StartupStep> step);
  /// States that the operator has done a step (`Startup::confirm`).
  /// @throws InvalidInput, Rejected as `Startup::confirm`; Rejected if a job is under way
  void confirm(StartupStep step);
  /// States that a program has arrived completely (`Startup::onTransferred`).
  /// @throws InvalidInput, Rejected as `Startup::onTransferred`; Rejected if a job is under way
  void transferred(const ProgramIdentity& program);
  /// Stops the running step and sends `startup.abort_code`. Returns at once.
  /// @throws Rejected if a job is under way, or there is no sequence
  void abort();
  /// Whether a step is running, or `abort` is under way.
  bool isBusy() const;

  /// Checks the machine and lends its port to a job until `endJob`. Gives up, and stops a check under way, as
  /// soon as the job is no longer to begin.
  /// @throws Rejected naming the first step that is neither Done nor Skipped, and the reason; also if a step
  ///   is running, or the program is not the one that was transferred
  /// @throws DeviceError if the machine cannot be reached
  /// @throws Cancelled if the job is no longer to begin
  void beginJob(const ProgramIdentity& program, const MayGoOn& mayGoOn);
  /// States that the job begins to send a program, and watches the machine from now on (`JobWatch`). If lines
  /// may be replaced, the program's commands count as sent somewhat too early. To be called, like `losses`
  /// and `endJob`, from the job's thread, which may wait for the program's disk.
  void watchJob(const StreamableProgram& program, WatchedLines lines);
  /// The conditions of the start-up that the machine has lost during the job and that the program has not
  /// ended (`JobWatch`); empty without a sequence.
  /// @param status  present status of the job
  std::vector<JobLoss> losses(const StreamStatus& status);
  /// Commands, one on each line, that ask the machine during a job for values that it does not report by
  /// itself and that steps of the sequence need. Empty if there is nothing to ask.
  std::string questions() const;
  /// States that the machine has sent a line during the job.
  void heard(const FirmwareReply& reply);
  /// States that the job is over. Steps whose result the job has ended, for example by switching off the bed,
  /// are Pending again. After a failure other than a cancellation the machine counts as unknown: power, bed,
  /// vacuum, homing and height map are Pending again.
  void endJob(const StreamableProgram& program, const StreamStatus& status);

  /// Ends the session as the destructor does, and returns once the machine is left safe. To be called by one
  /// thread. Steps and jobs are Rejected from then on; a job that has the port has to end first.
  void end();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
