// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/standing_alarms.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(StandingAlarms, RiseAgainOnlyAfterTheyWereDown) {
  StandingAlarms alarms;
  const RaisedAlarm silent{LoopAlarm::Silent, LoopReaction::Coast, "nothing"};
  const RaisedAlarm stuck{LoopAlarm::Stuck, LoopReaction::Coast, "all the same"};
  EXPECT_EQ(alarms.risen({silent}).size(), 1U);
  const auto risen = alarms.risen({silent, stuck});
  ASSERT_EQ(risen.size(), 1U);
  EXPECT_EQ(risen[0].alarm, LoopAlarm::Stuck);
  EXPECT_TRUE(alarms.isUp(LoopAlarm::Silent));
  EXPECT_TRUE(alarms.risen({stuck}).empty());
  EXPECT_FALSE(alarms.isUp(LoopAlarm::Silent));
  EXPECT_EQ(alarms.risen({silent, stuck}).size(), 1U);
}

}  // namespace
}  // namespace lamina
