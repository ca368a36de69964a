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

/// How a unit behaves where the standard leaves it open.
struct UnitSettings {
  HoldRule hold_rule = HoldRule::AlsoOnTheWay;
  std::vector<UnitMode> modes = standardModes();
  /// [s] that an acting state may last, by state number - 1; 0 for any time.
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

struct CommandAnswer {
  CommandResult result = CommandResult::Accepted;
  std::string reason;  ///< empty if accepted; else what was asked, the state, and what would be accepted
};

/// What stands against a command: a number of the table in docs/cell/cell.md, and a sentence with the value
/// found.
struct UnmetGuard {
  int code = 0;
  std::string sentence;
};

struct UnitRequest {
  UnitCommand command = UnitCommand::Stop;
  std::string source;  ///< who asks: "plc", "page: anna"
  std::optional<std::uint32_t>
      expected_sequence;          ///< of the state changes; refused if there were others since
  std::vector<UnmetGuard> unmet;  ///< all that stands against it, as found by the caller
};

/// A change of state or mode that has happened.
struct UnitChange {
  double time_s = 0.0;
  std::uint32_t sequence = 0;  ///< of state changes, from 1
  int mode = kProduction;      ///< after the change
  UnitState from = UnitState::Stopped;
  UnitState to = UnitState::Stopped;
  std::optional<UnitCommand> command;  ///< nothing: the state was complete, or the mode has changed
  std::string source;
  std::string reason;  ///< of alarms and time-outs
  int alarm = 0;       ///< that led to it; 0 for none
};

/// Where a unit is. Equal events at equal times lead to equal statuses.
struct UnitStatus {
  int mode = kProduction;
  UnitState state = UnitState::Stopped;
  std::uint32_t sequence = 0;  ///< of the last state change
  double state_since_s = 0.0;
  double mode_since_s = 0.0;
  std::optional<ActiveAlarm> stop_reason;  ///< the first alarm that moved the unit since it last ran
  ActiveAlarms alarms;
  UnitCounters counters;
};

/// The unit of a cell: takes commands, alarms and completed states with the time they came at, and says what
/// has changed. It moves nothing by itself: whoever drives it reads the changes and gives orders to the
/// executors.
class UnitMachine {
 public:
  /// @param first  Aborted if a job was cut off, else Stopped
  UnitMachine(UnitSettings settings, UnitState first, UnitCounters counters, double now_s);

  const UnitStatus& status() const { return status_; }

  /// Answers a command, and follows it if it is accepted. What is refused changes nothing.
  /// Start, Unhold and Unsuspend are refused while an alarm from Suspend on is active, Reset and Clear while
  /// one from Hold on is. Stop, Hold and Abort look at neither guards nor sequence.
  CommandAnswer command(const UnitRequest& request, double now_s);

  /// Answers the commands of one instant, each in its place, by their `precedence`; `done` is the acting
  /// state that was completed at that instant.
  std::vector<CommandAnswer> step(const std::vector<UnitRequest>& requests, std::optional<UnitState> done,
                                  double now_s);

  /// Changes the mode: in Idle, Stopped or Aborted, to a mode that has this state.
  CommandAnswer changeMode(int mode, const std::string& source, double now_s);

  /// The acting state has done what it is for. Without effect if the unit is in another state by now.
  /// Clearing goes on until no cause of category Abort is left. Execute without Completing in its mode goes
  /// to Stopping.
  void complete(UnitState state, double now_s);

  /// Raises an alarm and follows the command of its category. If the unit is on its way and its state or mode
  /// lacks that command, Suspend becomes Hold, and Hold becomes Stop.
  /// @return false for a repetition within a second, which is counted but not to be reported
  /// @throws InvalidInput if the table has no alarm of that ID
  bool raise(int alarm, double value, const std::string& message, double now_s);

  void end(int alarm, double now_s) { status_.alarms.end(alarm, now_s); }

  /// BadValue if no such alarm is active.
  CommandAnswer acknowledge(int alarm, const std::string& by, double now_s);

  /// Lets time pass: an acting state that lasts too long raises alarm 1010; Aborting that nobody confirms
  /// ends in Aborted.
  void tick(double now_s);

  /// A part is done, of that much material.
  void countPart(PartVerdict verdict, double material_mm3);

  /// What has changed since the last call, oldest first.
  std::vector<UnitChange> takeChanges();

 private:
  const UnitMode& mode() const;
  void enter(UnitState state, UnitChange change, double now_s);
  bool follow(UnitCommand command, const ActiveAlarm& alarm, double now_s);
  void react(const ActiveAlarm& alarm, double now_s);
  std::optional<CommandAnswer> refusal(const UnitRequest& request, UnitState next) const;
  void note(int alarm, const std::string& source, double now_s);
  void count(double now_s);

  UnitSettings settings_;
  UnitStatus status_;
  double counted_until_s_ = 0.0;
  std::vector<UnitChange> changes_;
};

}  // namespace lamina
