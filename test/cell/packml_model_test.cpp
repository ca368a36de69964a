// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/packml_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace lamina {
namespace {

/// What each command leads to, by state: one row per state in the order of the numbers 1 to 17, one column
/// per command in the order of the numbers 1 to 10; 0 where it is refused. Written down from the tables of
/// OPC 30050.
constexpr int kAnswers[17][10] = {
    // Reset Start Stop Hold Unhold Suspend Unsuspend Abort Clear Complete
    {0, 0, 0, 0, 0, 0, 0, 8, 0, 0},     // Clearing
    {15, 0, 0, 0, 0, 0, 0, 8, 0, 0},    // Stopped
    {0, 0, 7, 10, 0, 0, 0, 8, 0, 0},    // Starting
    {0, 3, 7, 0, 0, 0, 0, 8, 0, 0},     // Idle
    {0, 0, 7, 10, 0, 0, 14, 8, 0, 0},   // Suspended
    {0, 0, 7, 10, 0, 13, 0, 8, 0, 16},  // Execute
    {0, 0, 0, 0, 0, 0, 0, 8, 0, 0},     // Stopping
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0},     // Aborting
    {0, 0, 0, 0, 0, 0, 0, 0, 1, 0},     // Aborted
    {0, 0, 7, 0, 0, 0, 0, 8, 0, 0},     // Holding
    {0, 0, 7, 0, 12, 0, 0, 8, 0, 0},    // Held
    {0, 0, 7, 10, 0, 0, 0, 8, 0, 0},    // Unholding
    {0, 0, 7, 10, 0, 0, 0, 8, 0, 0},    // Suspending
    {0, 0, 7, 10, 0, 0, 0, 8, 0, 0},    // Unsuspending
    {0, 0, 7, 0, 0, 0, 0, 8, 0, 0},     // Resetting
    {0, 0, 7, 0, 0, 0, 0, 8, 0, 0},     // Completing
    {15, 0, 7, 0, 0, 0, 0, 8, 0, 0},    // Complete
};

/// The state that each acting state is completed into, by number; 0 for states that wait.
constexpr int kCompleted[17] = {2, 0, 6, 0, 0, 16, 2, 9, 0, 11, 0, 6, 5, 6, 4, 17, 0};

int numberOf(std::optional<UnitState> state) { return state ? static_cast<int>(*state) : 0; }

const UnitMode& standardMode(int number) {
  static const std::vector<UnitMode> kModes = standardModes();
  return kModes.at(static_cast<std::size_t>(number) - 1);
}

TEST(PackmlModel, AnswersEachCommandInEachStateByTheTable) {
  for (int state = 1; state <= 17; ++state)
    for (int command = 1; command <= 10; ++command)
      EXPECT_EQ(numberOf(commanded(*unitState(state), *unitCommand(command), HoldRule::AlsoOnTheWay)),
                kAnswers[state - 1][command - 1])
          << toString(*unitCommand(command)) << " in " << toString(*unitState(state));
}

TEST(PackmlModel, HoldsInExecuteAloneIfNotExtended) {
  for (const UnitState state : unitStates())
    EXPECT_EQ(commanded(state, UnitCommand::Hold, HoldRule::InExecute).has_value(),
              state == UnitState::Execute)
        << toString(state);
}

TEST(PackmlModel, CompletesEachActingState) {
  for (int state = 1; state <= 17; ++state) {
    EXPECT_EQ(numberOf(completed(*unitState(state))), kCompleted[state - 1]) << toString(*unitState(state));
    EXPECT_EQ(isActing(*unitState(state)), kCompleted[state - 1] != 0);
  }
}

TEST(PackmlModel, ListsWhatAStateAccepts) {
  const std::vector<UnitCommand> held = {UnitCommand::Stop, UnitCommand::Unhold, UnitCommand::Abort};
  EXPECT_EQ(acceptedIn(UnitState::Held, HoldRule::AlsoOnTheWay), held);
  EXPECT_TRUE(acceptedIn(UnitState::Aborting, HoldRule::AlsoOnTheWay).empty());
}

TEST(PackmlModel, HasTheStatesOfEachMode) {
  EXPECT_EQ(standardMode(kProduction).states.size(), 17U);
  const std::vector<std::string> not_in_maintenance = {"Suspended", "Suspending", "Unsuspending",
                                                       "Completing", "Complete"};
  const std::vector<std::string> in_manual = {"Clearing", "Stopped",  "Resetting", "Idle",   "Starting",
                                              "Execute",  "Stopping", "Aborting",  "Aborted"};
  const auto names = [](const std::vector<std::string>& list, UnitState state) {
    return std::find(list.begin(), list.end(), toString(state)) != list.end();
  };
  for (const UnitState state : unitStates()) {
    EXPECT_EQ(hasState(standardMode(kMaintenance), state), !names(not_in_maintenance, state))
        << toString(state);
    EXPECT_EQ(hasState(standardMode(kManual), state), names(in_manual, state)) << toString(state);
  }
}

TEST(PackmlModel, ChangesModeAtRestOnly) {
  for (const UnitState state : unitStates())
    EXPECT_EQ(canChangeMode(state),
              state == UnitState::Idle || state == UnitState::Stopped || state == UnitState::Aborted)
        << toString(state);
}

TEST(PackmlModel, KnowsNoNumbersBesideTheStandards) {
  EXPECT_FALSE(unitState(0));
  EXPECT_FALSE(unitState(18));
  EXPECT_FALSE(unitCommand(0));
  EXPECT_FALSE(unitCommand(11));
  EXPECT_STREQ(toString(*unitState(14)), "Unsuspending");
  EXPECT_STREQ(toString(*unitCommand(10)), "Complete");
}

TEST(PackmlModel, RanksWhatStopsBeforeWhatGoesOn) {
  EXPECT_LT(precedence(UnitCommand::Abort), precedence(UnitCommand::Stop));
  EXPECT_LT(precedence(UnitCommand::Stop), precedence(UnitCommand::Hold));
  EXPECT_LT(precedence(UnitCommand::Hold), precedence(UnitCommand::Suspend));
  EXPECT_LT(precedence(UnitCommand::Suspend), precedence(UnitCommand::Start));
}

}  // namespace
}  // namespace lamina
