// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/startup/machine_reports.hpp"
#include "lamina/startup/program_identity.hpp"
#include "lamina/startup/startup_sequence.hpp"
#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// The progress of a machine's start-up sequence: a state machine that does no input or output and reads no
/// clock. Its inputs are requests, replies of the machine, commands sent to it, and times; its outputs are
/// G-code to send, and the states of the steps. Times are machine times [s] since any start and never go
/// back.
///
/// A step is Pending at first. `begin` or `confirm` starts it, and is refused unless all its prerequisites
/// are satisfied. The step is then Running; the caller sends what `nextCode` returns and reports its end by
/// `onCodeFinished`, until the step is Done or Failed. If its result is lost later (a cold bed, motors that
/// were switched off, a zone that leaks, pellets that are no longer dry), the step is Pending again, and with
/// it every step that depends on it (`OnLoss::Spreads`).
///
/// No state is kept between runs of the program: a Startup begins with every step Pending.
class Startup {
 public:
  /// @throws InvalidConfig as `makeStartupSequence`
  explicit Startup(const StartupSettings& settings);

  /// Whether the sequence has no steps; a job may then always start.
  bool isEmpty() const { return entries_.empty(); }
  /// The status of each step, in the order of the sequence.
  std::vector<StartupStatus> steps() const;
  /// Whether a step is in the sequence and not skipped.
  bool awaits(StartupStep step) const;
  /// Whether a step that the machine runs or reports is Running or Done.
  bool hasMachineAtWork() const;
  /// Whether every step is Done or Skipped.
  bool isReady() const;
  /// Requires that every step is Done or Skipped.
  /// @throws Rejected naming the first step that is not, and the reason
  void requireReady() const;
  /// Requires that every step is Done or Skipped, and that the program is the one that was transferred. The
  /// program is not checked if the step TransferProgram is Skipped or not in the sequence.
  /// @throws Rejected naming the step or the program, and the reason
  void requireReadyFor(const ProgramIdentity& program) const;
  /// The state of a step; Skipped if it is not in the sequence.
  StartupState stateOf(StartupStep step) const;
  /// The first step of the sequence that is Pending or Failed and can be run now without the operator;
  /// nothing if there is none.
  std::optional<StartupStep> nextAutomatic() const;

  /// Begins a step that the machine does.
  /// @throws InvalidInput if the step is not in the sequence
  /// @throws Rejected if the operator does the step, it is running, a prerequisite is not satisfied, or both
  ///   the step and a step that depends on it are done
  void begin(StartupStep step, double now_s);
  /// States that the operator has done a step, or has begun one that takes time (the dryer, the bed).
  /// @throws InvalidInput, Rejected as `begin`; Rejected if the machine does the step
  void confirm(StartupStep step, double now_s);
  /// States that a program has arrived completely.
  /// @throws InvalidInput, Rejected as `begin`
  void onTransferred(const ProgramIdentity& program, double now_s);

  /// The G-code to send next for a running step; nothing if there is none to send now.
  std::optional<std::string> nextCode(StartupStep step);
  /// States that the machine has run the G-code of `nextCode` to its end.
  void onCodeFinished(StartupStep step, double now_s);
  /// States that a running step cannot be completed; it is then Failed.
  void fail(StartupStep step, const std::string& why);
  /// Adds a remark to the reason of a step that is Failed.
  void addRemark(StartupStep step, const std::string& remark);
  /// States that a running step is given up; it is then Pending.
  void giveUp(StartupStep step, const std::string& why);

  /// States that the machine has sent a line.
  void onReply(const FirmwareReply& reply, double now_s);
  /// States that a command was sent to the machine, by this sequence or a job.
  void onCommandSent(const std::string& command);
  /// States that the machine was reset or halted, or cannot be reached, so that its state is unknown.
  void forgetMachine(const std::string& why);
  /// Advances to a time: waits may end, and results may expire.
  void elapse(double now_s);

 private:
  struct Entry {
    std::vector<Prerequisite> after;
    StartupStatus status;
    double since_s = 0.0;  ///< time at which the step began; once it is done, time at which it was done
    int phase = 0;         ///< number of pieces of G-code that were run
  };

  Entry* find(StartupStep step);
  const Entry* find(StartupStep step) const;
  Entry& entryOf(StartupStep step);
  bool isSatisfiedAt(StartupStep step) const;
  const Prerequisite* firstUnmet(const Entry& entry) const;
  void requireMayBegin(const Entry& entry) const;
  void enter(StartupStep step, double now_s);
  std::string reasonOf(const Entry& entry) const;

  void complete(Entry& entry, const std::string& reason, double now_s);
  void measure(Entry& entry);
  void finishBed(Entry& entry, double now_s);
  void finishVacuum(Entry& entry, double now_s);
  void advanceDrying(Entry& entry, double now_s);
  void watch(Entry& entry);
  void halt(const std::string& why);

  void lose(StartupStep step, const std::string& why);
  void loseWith(StartupStep step, const std::string& reason, const std::string& cause);
  void loseHoming(const std::string& axes, const std::string& why);
  void expire(double now_s);

  StartupSettings settings_;
  std::vector<Entry> entries_;
  MachineReports reports_;
  std::vector<std::string> vacuum_off_;
  double dried_s_ = 0.0;
  double last_dry_s_ = 0.0;     ///< time at which the pellets were last known to be dried or kept dry
  bool was_dryer_hot_ = false;  ///< whether the dryer was hot when it was last checked
  double dryer_looked_at_s_ = 0.0;
  ProgramIdentity program_;  ///< program that was transferred
};

}  // namespace lamina
