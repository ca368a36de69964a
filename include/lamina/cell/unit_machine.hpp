// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/active_alarms.hpp"
#include "lamina/cell/packml_model.hpp"
#include "lamina/cell/unit_counters.hpp"

namespace lamina {

/// The behaviour of a unit where the standard leaves it open.
struct UnitSettings {
  HoldRule hold_rule = HoldRule::AlsoOnTheWay;
  std::vector<UnitMode> modes = standardModes();
  /// Greatest time [s] in an acting state, by state number - 1; 0 for no limit.
  std::array<double, 17> longest_s = {60, 0, 7200, 0, 0, 0, 60, 20, 0, 30, 0, 1800, 30, 1800, 60, 3600, 0};
};

enum class PartVerdict : std::uint8_t { Good, Defective };

/// Answer to a command, by the number that the PLC reads.
enum class CommandResult : std::uint8_t {
  Accepted = 1,
  NotInThisState = 2,
  NotInThisMode = 3,
  RemoteLocked = 4,
  NoSuchJob = 5,
  GuardFailed = 6,
  Busy = 7,
  BadValue = 8,
  WatchdogLost = 9,
  StaleSequence = 10,
};

/// The answer to a command.
struct CommandAnswer {
  CommandResult result = CommandResult::Accepted;
  /// Empty if the command was accepted; otherwise what was asked, the state, and what would be accepted.
  std::string reason;
};

/// A reason against a command: its number in the table of docs/cell/cell.md, and a sentence with the present
/// value.
struct UnmetGuard {
  int code = 0;
  std::string sentence;
};

/// A command to the unit, with its origin.
struct UnitRequest {
  UnitCommand command = UnitCommand::Stop;
  std::string source;  ///< who gives the command: "plc", "page: anna"
  /// Sequence number of the last state change that the sender knows; the command is refused if there was
  /// another since.
  std::optional<std::uint32_t> expected_sequence;
  std::vector<UnmetGuard> unmet;  ///< reasons against it that the caller has found
};

/// A change of state or mode that has happened.
struct UnitChange {
  double time_s = 0.0;
  std::uint32_t sequence = 0;  ///< number of the state change, from 1
  int mode = kProduction;      ///< mode after the change
  UnitState from = UnitState::Stopped;
  UnitState to = UnitState::Stopped;
  std::optional<UnitCommand> command;  ///< nothing if a state was complete or the mode was changed
  std::string source;
  std::string reason;  ///< for alarms and time-outs
  int alarm = 0;       ///< ID of the alarm that led to it; 0 for none
};

/// The state of a unit. Equal events at equal times lead to equal statuses.
struct UnitStatus {
  int mode = kProduction;
  UnitState state = UnitState::Stopped;
  std::uint32_t sequence = 0;  ///< number of the last state change
  double state_since_s = 0.0;
  double mode_since_s = 0.0;
  /// First alarm that changed the state since the unit was last in Execute or Idle.
  std::optional<ActiveAlarm> stop_reason;
  ActiveAlarms alarms;
  UnitCounters counters;
};

/// The state machine of a cell's unit: it is given commands, alarms and completed states with their times,
/// and returns what has changed. It moves nothing itself: the caller reads the changes and gives orders to
/// the executors.
class UnitMachine {
 public:
  /// @param first  initial state: Aborted if a job was cut off, otherwise Stopped
  UnitMachine(UnitSettings settings, UnitState first, UnitCounters counters, double now_s);

  const UnitStatus& status() const { return status_; }

  /// Answers a command, and follows it if it is accepted. A refused command changes nothing. Start, Unhold
  /// and Unsuspend are refused while an alarm of category Suspend or graver is active; Reset and Clear while
  /// an alarm of category Hold or graver is active. For Stop, Hold and Abort neither guards nor sequence are
  /// checked.
  CommandAnswer command(const UnitRequest& request, double now_s);

  /// Answers the commands that have arrived at the same time, following them in the order of their
  /// `precedence`.
  /// @param done  acting state that was completed at that time
  /// @return the answers, in the order of the requests
  std::vector<CommandAnswer> step(const std::vector<UnitRequest>& requests, std::optional<UnitState> done,
                                  double now_s);

  /// Changes the mode: in Idle, Stopped or Aborted, to a mode that has the present state.
  CommandAnswer changeMode(int mode, const std::string& source, double now_s);

  /// States that an acting state is complete; without effect if the unit is in another state by now. Clearing
  /// continues while the cause of an alarm of category Abort is present. If the mode lacks the state that
  /// follows (Completing after Execute), Stopping follows.
  void complete(UnitState state, double now_s);

  /// Raises an alarm and follows the command of its category. If state or mode do not allow the command,
  /// Suspend becomes Hold; while the unit runs or is about to, Hold becomes Stop.
  /// @return false for a repetition within a second, which is counted but not to be reported
  /// @throws InvalidInput if the table has no alarm of that ID
  bool raise(int alarm, double value, const std::string& message, double now_s);

  /// States that the cause of an alarm is gone.
  void end(int alarm, double now_s) { status_.alarms.end(alarm, now_s); }

  /// Raises an alarm of an earlier run of the unit, whose source is not known any more: its cause counts as
  /// gone, and from category H on it waits to be acknowledged. The unit does not react to it. Unless the unit
  /// is in Execute or Idle, the alarm becomes the stop reason if there is none.
  /// @param raised_s  time at which it was raised; may be before that of the unit's first state
  /// @throws InvalidInput if the table has no alarm of that ID
  void restore(int alarm, double value, const std::string& message, double raised_s, double now_s);

  /// Reacts to an alarm that is active, as if it had just been raised.
  void reactTo(int alarm, double now_s);

  /// Acknowledges an alarm; the result is `BadValue` if no such alarm is active.
  /// @param by  name of the user
  CommandAnswer acknowledge(int alarm, const std::string& by, double now_s);

  /// Advances the time. An acting state that lasts longer than `longest_s` raises alarm 1010; Aborting then
  /// ends in Aborted, even without a confirmation that the unit is at rest.
  void tick(double now_s);

  /// Counts a finished part and its material.
  void countPart(PartVerdict verdict, double material_mm3);

  /// The changes since the last call, oldest first.
  std::vector<UnitChange> takeChanges();

  /// The alarms that the unit has raised by itself since the last call (1001, 1002, 1010), oldest first, as
  /// far as they are to be reported.
  std::vector<ActiveAlarm> takeAlarms();

  /// As `ActiveAlarms::takeReturned`.
  std::vector<ActiveAlarm> takeReturned(double now_s) { return status_.alarms.takeReturned(now_s); }

 private:
  const UnitMode& mode() const;
  void enter(UnitState state, UnitChange change, double now_s);
  bool follow(UnitCommand command, const ActiveAlarm& alarm, double now_s);
  void react(const ActiveAlarm& alarm, double now_s);
  std::optional<CommandAnswer> refusal(const UnitRequest& request, UnitState next) const;
  void note(int alarm, const std::string& source, double now_s);
  ActiveAlarm raiseOwn(int alarm, double value, const std::string& message, double now_s);
  void count(double now_s);

  UnitSettings settings_;
  UnitStatus status_;
  double counted_until_s_ = 0.0;
  std::vector<UnitChange> changes_;
  std::vector<ActiveAlarm> own_alarms_;
};

}  // namespace lamina
