// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/startup_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using lamina::StartupState;
using lamina::StartupStatus;
using lamina_msgs::StartupStep;

std::uint8_t number(StartupState state) { return static_cast<std::uint8_t>(state); }

TEST(StartupMessages, HaveTheNumbersOfTheStates) {
  EXPECT_EQ(number(StartupState::Pending), StartupStep::PENDING + 0);
  EXPECT_EQ(number(StartupState::Running), StartupStep::RUNNING + 0);
  EXPECT_EQ(number(StartupState::Done), StartupStep::DONE + 0);
  EXPECT_EQ(number(StartupState::Failed), StartupStep::FAILED + 0);
  EXPECT_EQ(number(StartupState::Skipped), StartupStep::SKIPPED + 0);
}

TEST(StartupMessages, ReportStateReasonAndWhatWasMeasured) {
  const StartupStatus hot{lamina::StartupStep::HeatBed,
                          StartupState::Running,
                          "the bed is at 71 degC",
                          71.0,
                          "degC",
                          "89 to 91 degC"};
  const StartupStatus open{
      lamina::StartupStep::PlaceSheet, StartupState::Pending, "not done yet", {}, "", ""};
  const auto messages = lamina::toMessages({hot, open});
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].name, "heat_bed");
  EXPECT_EQ(messages[0].state, StartupStep::RUNNING + 0);
  EXPECT_EQ(messages[0].state_name, "Running");
  EXPECT_EQ(messages[0].reason, "the bed is at 71 degC");
  EXPECT_DOUBLE_EQ(messages[0].value, 71.0);
  EXPECT_EQ(messages[0].unit, "degC");
  EXPECT_EQ(messages[0].expected, "89 to 91 degC");
  EXPECT_EQ(messages[1].name, "place_sheet");
  EXPECT_TRUE(std::isnan(messages[1].value));
}

}  // namespace
