// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

// The state model of a unit: the effect of each command in each state, and the states of each mode.
// Source: OPC 30050 (PackML), after ISA-TR88.00.02; docs/cell/cell.md.

/// State of the unit, by the standard's number. (`PackmlState` is the state of one job in one executor, with
/// the numbers of an older standard.)
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

/// Mode of the unit, which determines the states that it has. Numbers 1 to 3 are the standard's.
struct UnitMode {
  int number = 0;
  std::string name;
  std::vector<UnitState> states;  ///< in the order of their numbers
};

constexpr int kProduction = 1;  ///< jobs from the queue; all states
/// Start-up steps, calibrations and dry runs; without the states to suspend and to complete.
constexpr int kMaintenance = 2;
constexpr int kManual = 3;  ///< jogging and single outputs; without the states to hold, suspend and complete

/// The states in which Hold is accepted.
enum class HoldRule : std::uint8_t {
  InExecute,     ///< as in ISA-TR88.00.02
  AlsoOnTheWay,  ///< as in OPC 30050: Starting, Unholding, Suspending, Suspended, Unsuspending too
};

/// All states and commands, in the order of their numbers.
const std::array<UnitState, 17>& unitStates();
const std::array<UnitCommand, 10>& unitCommands();

/// The modes Production, Maintenance and Manual.
std::vector<UnitMode> standardModes();

/// Name of a state or command in the standard: "Execute", "Unhold".
const char* toString(UnitState state);
const char* toString(UnitCommand command);

/// The state or command of that number; nothing if there is none.
std::optional<UnitState> unitState(int number);
std::optional<UnitCommand> unitCommand(int number);

/// The state that a command leads to; nothing where the state does not accept it.
std::optional<UnitState> commanded(UnitState state, UnitCommand command, HoldRule rule);

/// The state that follows when an acting state is complete; nothing for a state that waits. Execute is
/// followed by Completing.
std::optional<UnitState> completed(UnitState state);

/// Whether a state ends by itself. Execute does, when its job has ended.
bool isActing(UnitState state);

/// The commands that a state accepts, in the order of their numbers.
std::vector<UnitCommand> acceptedIn(UnitState state, HoldRule rule);

/// Whether a mode has a state.
bool hasState(const UnitMode& mode, UnitState state);

/// Whether the mode can be changed in a state: in Idle, Stopped and Aborted.
bool canChangeMode(UnitState state);

/// Rank of a command among simultaneous ones, 0 being first: Abort 0, Stop 1, Hold 2, Suspend 3, all others
/// `kLastPrecedence`. The completion of a state comes just before these others.
constexpr int kLastPrecedence = 4;
int precedence(UnitCommand command);

}  // namespace lamina
