// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/height_controller/unit_hold.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(UnitHold, IsHeldByAUnitThatTakesIt) {
  EXPECT_TRUE(answerToHold(CommandResult::Accepted, "", std::nullopt).is_held);
}

/// A unit that unholds, or whose suspension ends, goes on with the next layer.
TEST(UnitHold, IsNotHeldByAUnitThatGoesOn) {
  for (const UnitState state : {UnitState::Starting, UnitState::Execute, UnitState::Unholding,
                                UnitState::Suspending, UnitState::Suspended, UnitState::Unsuspending}) {
    const PrintHold::Answer answer = answerToHold(CommandResult::NotInThisState, "not now", state);
    EXPECT_FALSE(answer.is_held) << static_cast<int>(state);
    EXPECT_TRUE(answer.is_passing) << static_cast<int>(state);
    EXPECT_EQ(answer.text, "the print is not held: not now");
  }
  for (const UnitState state : {UnitState::Holding, UnitState::Held, UnitState::Stopped, UnitState::Aborted,
                                UnitState::Idle, UnitState::Complete}) {
    const PrintHold::Answer answer = answerToHold(CommandResult::NotInThisState, "not now", state);
    EXPECT_TRUE(answer.is_held) << static_cast<int>(state);
    EXPECT_FALSE(answer.is_passing) << static_cast<int>(state);
  }
}

TEST(UnitHold, IsNotHeldByAUnitOfWhichNothingIsKnownOrThatHasAnotherReason) {
  EXPECT_FALSE(answerToHold(CommandResult::NotInThisState, "not now", std::nullopt).is_held);
  const PrintHold::Answer answer =
      answerToHold(CommandResult::NotInThisMode, "the mode has no Holding", UnitState::Held);
  EXPECT_FALSE(answer.is_held);
  EXPECT_FALSE(answer.is_passing) << "asking again changes nothing";
}

}  // namespace
}  // namespace lamina
