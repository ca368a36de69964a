// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/command_audit.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(CommandAudit, CountsWhatIsRefusedAgainWithinASecond) {
  CommandAudit audit;
  const UnitRequest start{UnitCommand::Start, "plc", std::nullopt, {}};
  const CommandAnswer refused{CommandResult::NotInThisState, "the state is Held"};
  const auto first = audit.rowOf(start, refused, {10.0, 1000.0});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->time_s, 1000.0);
  EXPECT_EQ(first->who, "plc");
  EXPECT_EQ(first->what, "Start");
  EXPECT_EQ(first->result, "the state is Held");
  EXPECT_FALSE(audit.rowOf(start, refused, {10.5, 1000.5}));
  EXPECT_FALSE(audit.rowOf(start, refused, {10.99, 1000.99}));
  EXPECT_TRUE(audit.rowOf({UnitCommand::Start, "anna", std::nullopt, {}}, refused, {10.995, 1000.995}))
      << "of somebody else";
  const auto again = audit.rowOf(start, refused, {11.0, 1001.0});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->result, "the state is Held") << "what was left out stands in the row before";
}

TEST(CommandAudit, SaysInTheNextRowWhatItHasLeftOut) {
  CommandAudit audit;
  const UnitRequest start{UnitCommand::Start, "plc", std::nullopt, {}};
  const CommandAnswer refused{CommandResult::NotInThisState, "no"};
  audit.rowOf(start, refused, {10.0, 1000.0});
  for (int i = 1; i <= 3; ++i) EXPECT_FALSE(audit.rowOf(start, refused, {10.0 + 0.1 * i, 1000.0}));
  const auto hold = audit.rowOf({UnitCommand::Hold, "anna", std::nullopt, {}}, {}, {10.4, 1000.4});
  ASSERT_TRUE(hold);
  EXPECT_EQ(hold->result, "accepted (before it, Start of 'plc' was refused 3 times more)");
}

}  // namespace
}  // namespace lamina
