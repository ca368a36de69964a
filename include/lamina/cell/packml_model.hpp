// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

// The state model of a unit: what each command does in each state, and which states a mode has.
// Source: OPC 30050 (PackML), after ISA-TR88.00.02; docs/cell/cell.md.

/// State of the unit, by the standard's number. `PackmlState` is the state of one job at one executor, which
/// has older numbers.
enum class UnitState : std::uint8_t {
  Clearing = 1,
  Stopped = 2,
  Starting = 3,
  Idle = 4,
  Suspended = 5,
  Execute = 6,
  Stopping = 7,
  Aborting = 8,
  Aborted = 9,
  Holding = 10,
  Held = 11,
  Unholding = 12,
  Suspending = 13,
  Unsuspending = 14,
  Resetting = 15,
  Completing = 16,
  Complete = 17,
};

/// Command to the unit, by the standard's number.
enum class UnitCommand : std::uint8_t {
  Reset = 1,
  Start = 2,
  Stop = 3,
  Hold = 4,
  Unhold = 5,
  Suspend = 6,
  Unsuspend = 7,
  Abort = 8,
  Clear = 9,
  Complete = 10,  ///< end the job after this layer
};

/// Mode of the unit: which of the states it has. Numbers 1 to 3 are the standard's.
struct UnitMode {
  int number = 0;
  std::string name;
  std::vector<UnitState> states;  ///< in the order of their numbers
};

constexpr int kProduction = 1;  ///< jobs from the queue: all states
constexpr int kMaintenance =
    2;                      ///< start-up steps, calibrations, dry runs: nothing is suspended or completed
constexpr int kManual = 3;  ///< jog and single outputs: nothing is held, suspended or completed

/// Where Hold is accepted.
enum class HoldRule : std::uint8_t {
  InExecute,     ///< as in ISA-TR88.00.02
  AlsoOnTheWay,  ///< also in Starting, Unholding, Suspending, Suspended and Unsuspending, as in OPC 30050
};

/// All states and commands, in the order of their numbers.
const std::array<UnitState, 17>& unitStates();
const std::array<UnitCommand, 10>& unitCommands();

/// Production, Maintenance and Manual.
std::vector<UnitMode> standardModes();

/// The names that the standard gives: "Execute", "Unhold".
const char* toString(UnitState state);
const char* toString(UnitCommand command);

/// The state or command of that number; nothing if there is none.
std::optional<UnitState> unitState(int number);
std::optional<UnitCommand> unitCommand(int number);

/// The state that a command leads to; nothing where the state does not accept it.
std::optional<UnitState> commanded(UnitState state, UnitCommand command, HoldRule rule);

/// The state after an acting state has done what it is for (state complete); nothing for states that wait.
/// Execute completes into Completing.
std::optional<UnitState> completed(UnitState state);

/// True for states that end by themselves. Execute is one: it ends when its job has ended.
bool isActing(UnitState state);

/// The commands that a state accepts, in the order of their numbers.
std::vector<UnitCommand> acceptedIn(UnitState state, HoldRule rule);

/// True if a mode has that state.
bool hasState(const UnitMode& mode, UnitState state);

/// True if the mode can be changed in that state: Idle, Stopped or Aborted.
bool canChangeMode(UnitState state);

/// Rank of a command among those of one instant: Abort 0, Stop 1, Hold 2, Suspend 3, all others
/// `kLastPrecedence`. The completion of a state ranks just before the last.
constexpr int kLastPrecedence = 4;
int precedence(UnitCommand command);

}  // namespace lamina
