// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/unit_machine.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace lamina {
namespace {

UnitMachine unitIn(UnitState state) { return {UnitSettings{}, state, UnitCounters{}, 0.0}; }

UnitRequest request(UnitCommand command) { return {command, "test", std::nullopt, {}}; }

CommandResult resultOf(UnitMachine& unit, UnitCommand command, double now_s = 1.0) {
  return unit.command(request(command), now_s).result;
}

/// Commands a unit in each state and lists the states it came to, as in the table of the model.
TEST(UnitMachine, FollowsTheModelInEveryStateAndMode) {
  for (const UnitMode& mode : standardModes())
    for (const UnitState state : mode.states)
      for (const UnitCommand command : unitCommands()) {
        UnitMachine there = unitIn(state);
        if (mode.number != kProduction) {
          if (!canChangeMode(state)) continue;
          ASSERT_EQ(there.changeMode(mode.number, "test", 0.0).result, CommandResult::Accepted);
        }
        const auto next = commanded(state, command, HoldRule::AlsoOnTheWay);
        const CommandAnswer answer = there.command(request(command), 1.0);
        const bool is_open = next && hasState(mode, *next);
        EXPECT_EQ(answer.result == CommandResult::Accepted, is_open);
        EXPECT_EQ(there.status().state, is_open ? *next : state);
        EXPECT_EQ(answer.reason.empty(), is_open) << "every refusal has a reason";
      }
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
