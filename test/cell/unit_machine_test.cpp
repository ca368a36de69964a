// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/unit_machine.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace lamina {
namespace {

UnitMachine unitIn(UnitState state) { return {UnitSettings{}, state, UnitCounters{}, 0.0}; }

UnitRequest request(UnitCommand command) { return {command, "test", std::nullopt, {}}; }

CommandResult resultOf(UnitMachine& unit, UnitCommand command, double now_s = 1.0) {
  return unit.command(request(command), now_s).result;
}

/// States by the standard's numbers.
using Numbers = std::set<int>;

int stateNumber(UnitState state) { return static_cast<int>(state); }

/// The states of each mode, by its number.
std::map<int, Numbers> statesOfModes() {
  return {{1, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17}},
          {2, {1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12, 15}},
          {3, {1, 2, 3, 4, 6, 7, 8, 9, 15}}};
}

struct Way {
  Numbers from;
  int to = 0;
};

/// Where each command leads, by its number; whatever the mode.
std::map<int, Way> waysOfCommands() {
  return {{1, {{2, 17}, 15}},
          {2, {{4}, 3}},
          {3, {{3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16, 17}, 7}},
          {4, {{3, 5, 6, 12, 13, 14}, 10}},
          {5, {{11}, 12}},
          {6, {{6}, 13}},
          {7, {{5}, 14}},
          {8, {{1, 2, 3, 4, 5, 6, 7, 10, 11, 12, 13, 14, 15, 16, 17}, 8}},
          {9, {{9}, 1}},
          {10, {{6}, 16}}};
}

/// A unit of that mode in each state that it comes to by commands and completions.
std::map<int, UnitMachine> unitsOfMode(int mode) {
  UnitMachine first = unitIn(UnitState::Stopped);
  EXPECT_EQ(first.changeMode(mode, "test", 0.0).result, CommandResult::Accepted);
  std::map<int, UnitMachine> units = {{2, first}};
  std::vector<UnitMachine> open = {first};
  const auto keep = [&](const UnitMachine& unit) {
    if (units.emplace(stateNumber(unit.status().state), unit).second) open.push_back(unit);
  };
  while (!open.empty()) {
    const UnitMachine unit = open.back();
    open.pop_back();
    for (const UnitCommand command : unitCommands()) {
      UnitMachine next = unit;
      resultOf(next, command);
      keep(next);
    }
    UnitMachine next = unit;
    next.complete(unit.status().state, 1.0);
    keep(next);
  }
  return units;
}

TEST(UnitMachine, ComesToTheStatesOfItsModeAndToNoOthers) {
  for (const auto& [mode, states] : statesOfModes()) {
    Numbers reached;
    for (const auto& [state, unit] : unitsOfMode(mode)) reached.insert(state);
    EXPECT_EQ(reached, states) << mode;
  }
}

TEST(UnitMachine, FollowsEachCommandInEveryStateOfEachMode) {
  const auto ways = waysOfCommands();
  for (const auto& [mode, states] : statesOfModes())
    for (const auto& [state, unit] : unitsOfMode(mode))
      for (const UnitCommand command : unitCommands()) {
        const Way& way = ways.at(static_cast<int>(command));
        UnitMachine there = unit;
        const CommandAnswer answer = there.command(request(command), 1.0);
        const bool is_open = way.from.count(state) != 0 && states.count(way.to) != 0;
        const std::string where = std::string(toString(command)) + " in state " + std::to_string(state) +
                                  " of mode " + std::to_string(mode);
        EXPECT_EQ(answer.result == CommandResult::Accepted, is_open) << where << ": " << answer.reason;
        EXPECT_EQ(stateNumber(there.status().state), is_open ? way.to : state) << where;
        EXPECT_EQ(answer.reason.empty(), is_open) << where << ": every refusal has a reason";
      }
}

TEST(UnitMachine, ChangesFromEachModeToEachInIdleStoppedAndAbortedAlone) {
  const Numbers at_rest = {2, 4, 9};
  int changes = 0;
  for (const auto& [from, states] : statesOfModes())
    for (const auto& [state, unit] : unitsOfMode(from))
      for (const auto& [to, others] : statesOfModes()) {
        UnitMachine there = unit;
        const CommandAnswer answer = there.changeMode(to, "test", 1.0);
        const bool is_open = at_rest.count(state) != 0;
        const std::string where = "state " + std::to_string(state) + " of mode " + std::to_string(from) +
                                  " to mode " + std::to_string(to);
        EXPECT_EQ(answer.result, is_open ? CommandResult::Accepted : CommandResult::NotInThisState) << where;
        EXPECT_EQ(there.status().mode, is_open ? to : from) << where;
        EXPECT_EQ(stateNumber(there.status().state), state) << where;
        ++changes;
      }
  EXPECT_EQ(changes, (17 + 12 + 9) * 3);
}

TEST(UnitMachine, ChangesNothingWhenItRefuses) {
  UnitMachine unit = unitIn(UnitState::Stopped);
  const CommandAnswer answer = unit.command(request(UnitCommand::Start), 1.0);
  EXPECT_EQ(answer.result, CommandResult::NotInThisState);
  EXPECT_EQ(answer.reason, "Start in Stopped (Production) is not accepted; accepted now: Reset, Abort");
  EXPECT_EQ(unit.status().sequence, 0U);
  EXPECT_TRUE(unit.takeChanges().empty());
}

TEST(UnitMachine, ReportsItsChangesOnce) {
  UnitMachine unit = unitIn(UnitState::Stopped);
  EXPECT_EQ(resultOf(unit, UnitCommand::Reset, 2.0), CommandResult::Accepted);
  unit.complete(UnitState::Resetting, 3.0);
  const std::vector<UnitChange> changes = unit.takeChanges();
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].from, UnitState::Stopped);
  EXPECT_EQ(changes[0].to, UnitState::Resetting);
  EXPECT_EQ(changes[0].command, UnitCommand::Reset);
  EXPECT_EQ(changes[0].sequence, 1U);
  EXPECT_EQ(changes[1].to, UnitState::Idle);
  EXPECT_FALSE(changes[1].command);
  EXPECT_DOUBLE_EQ(changes[1].time_s, 3.0);
  EXPECT_TRUE(unit.takeChanges().empty());
}

TEST(UnitMachine, NamesAllGuardsThatFail) {
  UnitMachine unit = unitIn(UnitState::Idle);
  UnitRequest start = request(UnitCommand::Start);
  start.unmet = {{1203, "the last part was not confirmed as removed"},
                 {7003, "the journal cannot be written"}};
  const CommandAnswer answer = unit.command(start, 1.0);
  EXPECT_EQ(answer.result, CommandResult::GuardFailed);
  EXPECT_NE(answer.reason.find("removed"), std::string::npos);
  EXPECT_NE(answer.reason.find("journal"), std::string::npos);
  EXPECT_EQ(unit.status().state, UnitState::Idle);
}

TEST(UnitMachine, RefusesWhatWasMeantForAnotherState) {
  UnitMachine unit = unitIn(UnitState::Stopped);
  resultOf(unit, UnitCommand::Reset);
  unit.complete(UnitState::Resetting, 2.0);
  UnitRequest start = request(UnitCommand::Start);
  start.expected_sequence = 1;
  EXPECT_EQ(unit.command(start, 3.0).result, CommandResult::StaleSequence);
  start.expected_sequence = 2;
  EXPECT_EQ(unit.command(start, 3.0).result, CommandResult::Accepted);
  UnitRequest stop = request(UnitCommand::Stop);
  stop.expected_sequence = 0;
  EXPECT_EQ(unit.command(stop, 4.0).result, CommandResult::Accepted) << "what stops is never stale";
}

TEST(UnitMachine, ChangesModeAtRestOnly) {
  UnitMachine unit = unitIn(UnitState::Execute);
  EXPECT_EQ(unit.changeMode(kManual, "test", 1.0).result, CommandResult::NotInThisState);
  UnitMachine resting = unitIn(UnitState::Idle);
  EXPECT_EQ(resting.changeMode(7, "test", 1.0).result, CommandResult::BadValue);
  EXPECT_EQ(resting.changeMode(kManual, "test", 1.0).result, CommandResult::Accepted);
  EXPECT_EQ(resting.status().mode, kManual);
  EXPECT_DOUBLE_EQ(resting.status().mode_since_s, 1.0);
}

TEST(UnitMachine, StopsAfterExecuteWhereAModeCompletesNothing) {
  UnitMachine unit = unitIn(UnitState::Idle);
  unit.changeMode(kMaintenance, "test", 0.0);
  resultOf(unit, UnitCommand::Start);
  unit.complete(UnitState::Starting, 2.0);
  ASSERT_EQ(unit.status().state, UnitState::Execute);
  EXPECT_EQ(resultOf(unit, UnitCommand::Suspend), CommandResult::NotInThisMode);
  unit.complete(UnitState::Execute, 3.0);
  EXPECT_EQ(unit.status().state, UnitState::Stopping);
}

TEST(UnitMachine, TakesTheGravestOfOneInstantFirst) {
  UnitMachine unit = unitIn(UnitState::Execute);
  const auto answers =
      unit.step({request(UnitCommand::Complete), request(UnitCommand::Hold), request(UnitCommand::Abort)},
                UnitState::Execute, 1.0);
  EXPECT_EQ(unit.status().state, UnitState::Aborting);
  EXPECT_EQ(answers[0].result, CommandResult::NotInThisState);
  EXPECT_EQ(answers[1].result, CommandResult::NotInThisState);
  EXPECT_EQ(answers[2].result, CommandResult::Accepted);
}

TEST(UnitMachine, IgnoresTheCompletionOfAStateItHasLeft) {
  UnitMachine unit = unitIn(UnitState::Starting);
  resultOf(unit, UnitCommand::Stop);
  unit.complete(UnitState::Starting, 2.0);
  EXPECT_EQ(unit.status().state, UnitState::Stopping);
}

struct Reaction {
  int alarm;
  UnitState in;
  UnitState leads_to;
};

TEST(UnitMachine, ReactsToAlarmsByTheirCategory) {
  const std::vector<Reaction> reactions = {
      {2102, UnitState::Execute, UnitState::Execute},      // warning
      {1204, UnitState::Execute, UnitState::Suspending},   // zone taken
      {1204, UnitState::Starting, UnitState::Holding},     // nothing to suspend yet
      {1205, UnitState::Suspended, UnitState::Suspended},  // suspended already
      {3202, UnitState::Suspended, UnitState::Holding},    // vacuum lost
      {3202, UnitState::Execute, UnitState::Holding},      //
      {3202, UnitState::Idle, UnitState::Idle},            // nothing to hold
      {3202, UnitState::Held, UnitState::Held},            //
      {3104, UnitState::Execute, UnitState::Aborting},     // heater fault
      {3104, UnitState::Idle, UnitState::Aborting},        //
      {3104, UnitState::Aborted, UnitState::Aborted},      //
  };
  for (const Reaction& reaction : reactions) {
    UnitMachine unit = unitIn(reaction.in);
    unit.raise(reaction.alarm, 1.0, "seen", 1.0);
    EXPECT_EQ(unit.status().state, reaction.leads_to) << reaction.alarm << " in " << toString(reaction.in);
    EXPECT_EQ(unit.status().stop_reason.has_value(), reaction.in != reaction.leads_to);
  }
}

TEST(UnitMachine, StopsWhereAModeCannotHold) {
  UnitMachine unit = unitIn(UnitState::Idle);
  unit.changeMode(kManual, "test", 0.0);
  resultOf(unit, UnitCommand::Start);
  unit.complete(UnitState::Starting, 2.0);
  unit.raise(3202, 0.0, "", 3.0);
  EXPECT_EQ(unit.status().state, UnitState::Stopping);
}

TEST(UnitMachine, GoesOnWhenTheCauseIsGoneAndAcknowledged) {
  UnitMachine unit = unitIn(UnitState::Execute);
  unit.raise(3202, 20.0, "vacuum is 20 kPa; expected at most 10 kPa", 1.0);
  unit.complete(UnitState::Holding, 2.0);
  EXPECT_EQ(resultOf(unit, UnitCommand::Unhold), CommandResult::GuardFailed);
  unit.end(3202, 3.0);
  EXPECT_EQ(resultOf(unit, UnitCommand::Unhold), CommandResult::GuardFailed) << "not acknowledged";
  EXPECT_EQ(unit.acknowledge(3202, "anna", 4.0).result, CommandResult::Accepted);
  EXPECT_EQ(resultOf(unit, UnitCommand::Unhold), CommandResult::Accepted);
  EXPECT_EQ(unit.acknowledge(3202, "anna", 5.0).result, CommandResult::BadValue);
}

TEST(UnitMachine, KeepsTheFirstAlarmAsItsStopReason) {
  UnitMachine unit = unitIn(UnitState::Execute);
  unit.raise(3202, 20.0, "", 1.0);
  unit.raise(3104, 300.0, "", 2.0);
  ASSERT_TRUE(unit.status().stop_reason);
  EXPECT_EQ(unit.status().stop_reason->id, 3202);
  UnitMachine commanded = unitIn(UnitState::Execute);
  resultOf(commanded, UnitCommand::Hold);
  ASSERT_TRUE(commanded.status().stop_reason);
  EXPECT_EQ(commanded.status().stop_reason->id, 1001);
}

TEST(UnitMachine, ClearsWhenNothingGraveIsLeft) {
  UnitMachine unit = unitIn(UnitState::Execute);
  unit.raise(3104, 300.0, "", 1.0);
  unit.complete(UnitState::Aborting, 2.0);
  EXPECT_EQ(resultOf(unit, UnitCommand::Clear), CommandResult::GuardFailed);
  unit.acknowledge(3104, "anna", 3.0);
  EXPECT_EQ(resultOf(unit, UnitCommand::Clear), CommandResult::Accepted);
  unit.complete(UnitState::Clearing, 4.0);
  EXPECT_EQ(unit.status().state, UnitState::Stopped);
}

TEST(UnitMachine, AbortsWhatLastsTooLong) {
  UnitMachine unit = unitIn(UnitState::Holding);
  unit.tick(30.0);
  EXPECT_EQ(unit.status().state, UnitState::Holding);
  unit.tick(30.1);
  EXPECT_EQ(unit.status().state, UnitState::Aborting);
  ASSERT_TRUE(unit.status().stop_reason);
  EXPECT_EQ(unit.status().stop_reason->id, 1010);
  unit.tick(50.2);
  EXPECT_EQ(unit.status().state, UnitState::Aborted) << "though nobody confirms";
}

TEST(UnitMachine, WaitsInWaitStatesAndExecuteForAnyTime) {
  for (const UnitState state : unitStates()) {
    if (isActing(state) && state != UnitState::Execute) continue;
    UnitMachine unit = unitIn(state);
    unit.tick(1e6);
    EXPECT_EQ(unit.status().state, state) << toString(state);
  }
}

TEST(UnitMachine, CountsTimeByModeAndState) {
  UnitMachine unit = unitIn(UnitState::Stopped);
  resultOf(unit, UnitCommand::Reset, 10.0);
  unit.complete(UnitState::Resetting, 12.5);
  unit.changeMode(kManual, "test", 20.0);
  unit.tick(23.0);
  const UnitCounters& counters = unit.status().counters;
  EXPECT_DOUBLE_EQ(timeIn(counters, kProduction, UnitState::Stopped), 10.0);
  EXPECT_DOUBLE_EQ(timeIn(counters, kProduction, UnitState::Resetting), 2.5);
  EXPECT_DOUBLE_EQ(timeIn(counters, kProduction, UnitState::Idle), 7.5);
  EXPECT_DOUBLE_EQ(timeIn(counters, kManual), 3.0);
  EXPECT_DOUBLE_EQ(totalTime(counters), 23.0);
}

/// Anything at any time: the unit moves along the model's arrows only, and in states of its mode.
TEST(UnitMachine, NeverLeavesTheModelOnARandomWalk) {
  std::mt19937 random(7);
  const auto pick = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  UnitMachine unit = unitIn(UnitState::Stopped);
  const std::vector<UnitMode> modes = standardModes();
  double now_s = 0.0;
  std::map<UnitState, int> entered;
  for (int i = 0; i < 1'000'000; ++i) {
    now_s += 0.01 * pick(100);
    const int event = pick(20);
    const bool ends_early = event < 10 && precedence(unitCommands().at(static_cast<std::size_t>(event))) < 2;
    // What ends a job comes seldom, so that the walk sees the states in which jobs go on.
    if ((ends_early || event == 17) && pick(10) > 0) continue;
    if (event < 10) {
      unit.command(request(unitCommands().at(static_cast<std::size_t>(event))), now_s);
    } else if (event < 16) {
      unit.complete(unit.status().state, now_s);
    } else if (event == 16) {
      unit.changeMode(1 + pick(4), "walk", now_s);
    } else if (event == 17) {
      unit.raise(alarmTable().at(static_cast<std::size_t>(pick(static_cast<int>(alarmTable().size())))).id,
                 0.0, "", now_s);
    } else if (event == 18) {
      unit.tick(now_s);
    } else {
      for (const ActiveAlarm& alarm : std::vector<ActiveAlarm>(unit.status().alarms.all())) {
        unit.end(alarm.id, now_s);
        unit.acknowledge(alarm.id, "walk", now_s);
      }
    }
    for (const UnitChange& change : unit.takeChanges()) {
      ++entered[change.to];
      const UnitMode& mode = modes.at(static_cast<std::size_t>(change.mode) - 1);
      ASSERT_TRUE(hasState(mode, change.to)) << toString(change.to) << " in " << mode.name;
      if (change.from == change.to) {
        ASSERT_TRUE(canChangeMode(change.from));
      } else if (change.command) {
        ASSERT_EQ(commanded(change.from, *change.command, HoldRule::AlsoOnTheWay), change.to);
      } else {
        const bool stops_instead = change.from == UnitState::Execute && change.to == UnitState::Stopping;
        ASSERT_TRUE(completed(change.from) == change.to || stops_instead) << toString(change.from);
      }
    }
  }
  for (const UnitState state : unitStates()) EXPECT_GT(entered[state], 100) << toString(state);
  unit.tick(now_s);
  EXPECT_NEAR(totalTime(unit.status().counters), now_s, 1e-3);
}

}  // namespace
}  // namespace lamina
