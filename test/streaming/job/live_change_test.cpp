// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/live_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string refusedAs(const std::string& name, double value) {
  try {
    liveChange(name, value);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "nothing was thrown";
}

TEST(LiveChange, IsNamedAndBounded) {
  EXPECT_EQ(liveChange("feed", 95.0).setting, LiveSetting::Feed);
  EXPECT_EQ(liveChange("flow", 105.5).setting, LiveSetting::Flow);
  EXPECT_DOUBLE_EQ(liveChange("babystep", -0.05).value, -0.05);
  EXPECT_EQ(liveChange("cancel_part", 3.0).setting, LiveSetting::CancelPart);
  EXPECT_EQ(liveChange("pause_at_layer", 12.0).setting, LiveSetting::PauseAtLayer);
  EXPECT_EQ(refusedAs("feed", 500.0), "feed is 500 %; must be from 10 to 300 %");
  EXPECT_EQ(refusedAs("babystep", 0.6), "babystep is 0.6 mm; must be from -0.5 to 0.5 mm");
  EXPECT_EQ(refusedAs("cancel_part", 1.5), "cancel_part is 1.5; must be a whole number from 0 to 9999");
  EXPECT_NE(refusedAs("feed", std::nan("")), "nothing was thrown");
  EXPECT_EQ(refusedAs("colour", 1.0),
            "'colour' cannot be changed while a job runs; expected one of feed, flow, babystep, cancel_part, "
            "pause_at_layer, rapid, spindle, power");
  EXPECT_EQ(liveChange("rapid", 50.0).setting, LiveSetting::Rapid);
  EXPECT_EQ(refusedAs("spindle", 250.0), "spindle is 250 %; must be a whole number from 10 to 200 %");
  EXPECT_EQ(liveChange("power", 90.0).setting, LiveSetting::Power);
  EXPECT_EQ(refusedAs("power", 201.0), "power is 201 %; must be a whole number from 10 to 200 %");
  EXPECT_EQ(refusedAs("flow", 301.0), "flow is 301 %; must be from 10 to 300 %");
  EXPECT_EQ(notOf("Marlin", LiveSetting::Power), "Marlin has no power");
  EXPECT_EQ(notOf("grbl", LiveSetting::CancelPart), "grbl has no cancel_part");
}

}  // namespace
}  // namespace lamina
