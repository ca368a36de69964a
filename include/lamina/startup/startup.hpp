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

/// How far a machine's start-up is: a state machine without input, output or time of its own. Requests,
/// replies of the machine, commands sent to it and times go in; G-code to send and the states of the steps
/// come out. Times are machine times [s] since any start and never go back.
///
/// A step is Pending at first. `begin` or `confirm` starts it, and is refused unless all that must come
/// before the step is satisfied. The step is then Running, while `nextCode` is sent and `onCodeFinished`
/// reported, and ends Done or Failed. If its result is lost afterwards (a cold bed, motors that were switched
/// off, a zone that leaks, pellets that are no longer dry), it is Pending again, and so is every step that
/// rests on it.
///
/// Nothing is carried over from an earlier run: a Startup begins with every step Pending.
class Startup {
 public:
  /// @throws InvalidConfig as `makeStartupSequence`
  explicit Startup(const StartupSettings& settings);

  /// Whether there is no sequence: then a job may always start.
  bool isEmpty() const { return entries_.empty(); }
  /// How each step is, in their order.
  std::vector<StartupStatus> steps() const;
  /// Whether the step is in the sequence and not left out.
  bool awaits(StartupStep step) const;
  /// Whether a step that the machine runs or reports is under way or done.
  bool hasMachineAtWork() const;
  /// Whether every step is satisfied.
  bool isReady() const;
  /// @throws Rejected naming the first step that is not satisfied, and its reason
  void requireReady() const;
  /// @throws Rejected as `requireReady`, or if the program is not the one that was transferred
  void requireReadyFor(const ProgramIdentity& program) const;
  /// Skipped if the step is not in the sequence.
  StartupState stateOf(StartupStep step) const;
  /// The first step of the sequence that is Pending or Failed and can be run now without the operator.
  std::optional<StartupStep> nextAutomatic() const;

  /// Begins a step that the machine does.
  /// @throws InvalidInput if the step is not in the sequence
  /// @throws Rejected if the operator does the step, it is running, something must come before it, or it is
  ///   done and so is a step that rests on it
  void begin(StartupStep step, double now_s);
  /// The operator has done a step, or has begun one that takes time (the dryer, the bed).
  /// @throws InvalidInput, Rejected as `begin`; Rejected if the machine does the step
  void confirm(StartupStep step, double now_s);
  /// A program has arrived whole.
  /// @throws InvalidInput, Rejected as `begin`
  void onTransferred(const ProgramIdentity& program, double now_s);

  /// G-code to send next for a running step; nothing if there is none to send now.
  std::optional<std::string> nextCode(StartupStep step);
  /// That G-code was run to its end.
  void onCodeFinished(StartupStep step, double now_s);
  /// A running step cannot be brought to its end.
  void fail(StartupStep step, const std::string& why);
  /// Adds to the reason of a step that has failed.
  void addRemark(StartupStep step, const std::string& remark);
  /// A running step is given up: it is Pending again.
  void giveUp(StartupStep step, const std::string& why);

  /// The machine has said something.
  void onReply(const FirmwareReply& reply, double now_s);
  /// A command was sent to the machine, by whomever.
  void onCommandSent(const std::string& command);
  /// States that the machine was reset or halted, or cannot be reached: nothing is known of its state any
  /// more.
  void forgetMachine(const std::string& why);
  /// Time has passed: what is waited for may be over, what was done may be lost.
  void elapse(double now_s);

 private:
  struct Entry {
    std::vector<Prerequisite> after;
    StartupStatus status;
    double since_s = 0.0;  ///< when it began, and then when it was done
    int phase = 0;         ///< pieces of G-code that were run
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
  double last_dry_s_ = 0.0;     ///< when the pellets were last known to be dried or kept dry
  bool was_dryer_hot_ = false;  ///< at the last time it was looked at
  double dryer_looked_at_s_ = 0.0;
  ProgramIdentity program_;  ///< that was transferred
};

}  // namespace lamina
