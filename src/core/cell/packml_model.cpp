// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/packml_model.hpp"

#include <algorithm>
#include <initializer_list>

namespace lamina {
namespace {

using S = UnitState;
using C = UnitCommand;

bool isOneOf(S state, std::initializer_list<S> states) {
  return std::find(states.begin(), states.end(), state) != states.end();
}

bool acceptsHold(S state, HoldRule rule) {
  if (state == S::Execute) return true;
  return rule == HoldRule::AlsoOnTheWay &&
         isOneOf(state, {S::Starting, S::Unholding, S::Suspending, S::Suspended, S::Unsuspending});
}

bool isAccepted(S state, C command, HoldRule rule) {
  switch (command) {
    case C::Reset:
      return isOneOf(state, {S::Stopped, S::Complete});
    case C::Start:
      return state == S::Idle;
    case C::Stop:
      return !isOneOf(state, {S::Stopping, S::Stopped, S::Aborting, S::Aborted, S::Clearing});
    case C::Hold:
      return acceptsHold(state, rule);
    case C::Unhold:
      return state == S::Held;
    case C::Suspend:
    case C::Complete:
      return state == S::Execute;
    case C::Unsuspend:
      return state == S::Suspended;
    case C::Abort:
      return !isOneOf(state, {S::Aborting, S::Aborted});
    case C::Clear:
      return state == S::Aborted;
  }
  return false;
}

S leadsTo(C command) {
  switch (command) {
    case C::Reset:
      return S::Resetting;
    case C::Start:
      return S::Starting;
    case C::Stop:
      return S::Stopping;
    case C::Hold:
      return S::Holding;
    case C::Unhold:
      return S::Unholding;
    case C::Suspend:
      return S::Suspending;
    case C::Unsuspend:
      return S::Unsuspending;
    case C::Abort:
      return S::Aborting;
    case C::Clear:
      return S::Clearing;
    case C::Complete:
      return S::Completing;
  }
  return S::Aborting;
}

template <class Value, std::size_t kCount>
std::optional<Value> numbered(const std::array<Value, kCount>& values, int number) {
  if (number < 1 || number > static_cast<int>(kCount)) return std::nullopt;
  return values.at(static_cast<std::size_t>(number) - 1);
}

}  // namespace

const std::array<UnitState, 17>& unitStates() {
  static constexpr std::array<S, 17> kStates = {
      S::Clearing,   S::Stopped,      S::Starting,  S::Idle,       S::Suspended, S::Execute,
      S::Stopping,   S::Aborting,     S::Aborted,   S::Holding,    S::Held,      S::Unholding,
      S::Suspending, S::Unsuspending, S::Resetting, S::Completing, S::Complete};
  return kStates;
}

const std::array<UnitCommand, 10>& unitCommands() {
  static constexpr std::array<C, 10> kCommands = {C::Reset,   C::Start,     C::Stop,  C::Hold,  C::Unhold,
                                                  C::Suspend, C::Unsuspend, C::Abort, C::Clear, C::Complete};
  return kCommands;
}

std::vector<UnitMode> standardModes() {
  const std::vector<S> all(unitStates().begin(), unitStates().end());
  UnitMode maintenance{kMaintenance, "Maintenance", {}};
  UnitMode manual{kManual, "Manual", {}};
  for (const S state : all) {
    const bool waits_outside = isOneOf(state, {S::Suspending, S::Suspended, S::Unsuspending});
    const bool ends_jobs = isOneOf(state, {S::Completing, S::Complete});
    const bool waits_inside = isOneOf(state, {S::Holding, S::Held, S::Unholding});
    if (waits_outside || ends_jobs) continue;
    maintenance.states.push_back(state);
    if (!waits_inside) manual.states.push_back(state);
  }
  return {{kProduction, "Production", all}, maintenance, manual};
}

const char* toString(UnitState state) {
  switch (state) {
    case S::Clearing:
      return "Clearing";
    case S::Stopped:
      return "Stopped";
    case S::Starting:
      return "Starting";
    case S::Idle:
      return "Idle";
    case S::Suspended:
      return "Suspended";
    case S::Execute:
      return "Execute";
    case S::Stopping:
      return "Stopping";
    case S::Aborting:
      return "Aborting";
    case S::Aborted:
      return "Aborted";
    case S::Holding:
      return "Holding";
    case S::Held:
      return "Held";
    case S::Unholding:
      return "Unholding";
    case S::Suspending:
      return "Suspending";
    case S::Unsuspending:
      return "Unsuspending";
    case S::Resetting:
      return "Resetting";
    case S::Completing:
      return "Completing";
    case S::Complete:
      return "Complete";
  }
  return "Unknown";
}

const char* toString(UnitCommand command) {
  switch (command) {
    case C::Reset:
      return "Reset";
    case C::Start:
      return "Start";
    case C::Stop:
      return "Stop";
    case C::Hold:
      return "Hold";
    case C::Unhold:
      return "Unhold";
    case C::Suspend:
      return "Suspend";
    case C::Unsuspend:
      return "Unsuspend";
    case C::Abort:
      return "Abort";
    case C::Clear:
      return "Clear";
    case C::Complete:
      return "Complete";
  }
  return "Unknown";
}

std::optional<UnitState> unitState(int number) { return numbered(unitStates(), number); }

std::optional<UnitCommand> unitCommand(int number) { return numbered(unitCommands(), number); }

std::optional<UnitState> commanded(UnitState state, UnitCommand command, HoldRule rule) {
  if (!isAccepted(state, command, rule)) return std::nullopt;
  return leadsTo(command);
}

std::optional<UnitState> completed(UnitState state) {
  switch (state) {
    case S::Clearing:
    case S::Stopping:
      return S::Stopped;
    case S::Starting:
    case S::Unholding:
    case S::Unsuspending:
      return S::Execute;
    case S::Execute:
      return S::Completing;
    case S::Aborting:
      return S::Aborted;
    case S::Holding:
      return S::Held;
    case S::Suspending:
      return S::Suspended;
    case S::Resetting:
      return S::Idle;
    case S::Completing:
      return S::Complete;
    case S::Stopped:
    case S::Idle:
    case S::Suspended:
    case S::Aborted:
    case S::Held:
    case S::Complete:
      return std::nullopt;
  }
  return std::nullopt;
}

bool isActing(UnitState state) { return completed(state).has_value(); }

std::vector<UnitCommand> acceptedIn(UnitState state, HoldRule rule) {
  std::vector<C> accepted;
  for (const C command : unitCommands())
    if (isAccepted(state, command, rule)) accepted.push_back(command);
  return accepted;
}

bool hasState(const UnitMode& mode, UnitState state) {
  return std::find(mode.states.begin(), mode.states.end(), state) != mode.states.end();
}

bool canChangeMode(UnitState state) { return isOneOf(state, {S::Idle, S::Stopped, S::Aborted}); }

int precedence(UnitCommand command) {
  switch (command) {
    case C::Abort:
      return 0;
    case C::Stop:
      return 1;
    case C::Hold:
      return 2;
    case C::Suspend:
      return 3;
    default:
      return kLastPrecedence;
  }
}

}  // namespace lamina
