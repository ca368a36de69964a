// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "streaming/emulator/grbl_link.hpp"

namespace lamina {
namespace {

using test::GrblLink;

/// A laser that is on while it runs slow moves of a minute in all.
StreamableProgram laserProgram() {
  std::string text = "G21\nG90\nM3 S1000\nG1 F60\n";
  for (int i = 1; i <= 30; ++i) text += "X" + std::to_string(2 * i) + "\n";
  return StreamableProgram::fromText("laser", text, test::reliableGrbl());
}

TEST(GrblOverrides, ScaleTheLasersPowerAmidALine) {
  GrblLink link(laserProgram(), test::reliableGrbl(), {}, {});
  link.start();
  link.runUntil(3.0);
  ASSERT_EQ(link.firmware.spindleSpeed(), 1000.0);
  EXPECT_EQ(link.streamer.change({LiveSetting::Spindle, 73.0}, link.now), "");
  link.runUntil(6.0);
  EXPECT_EQ(link.firmware.spindleSpeed(), 730.0);
  EXPECT_EQ(link.streamer.status().message, "");
  EXPECT_EQ(link.streamer.change({LiveSetting::Power, 90.0}, link.now), "");
  link.runUntil(9.0);
  EXPECT_EQ(link.firmware.spindleSpeed(), 900.0);
}

// Byte by byte from any override to any other.
RC_GTEST_PROP(GrblOverridesProperty, BecomeWhatWasAskedFor, ()) {
  GrblLink link(laserProgram(), test::reliableGrbl(), {}, {});
  link.start();
  link.runUntil(3.0);
  for (int i = 0; i < 3; ++i) {
    const int percent = *rc::gen::inRange(10, 201);
    RC_ASSERT(link.streamer.change({LiveSetting::Spindle, static_cast<double>(percent)}, link.now).empty());
    link.runUntil(link.now + 5.0);
    RC_ASSERT(std::abs(link.firmware.spindleSpeed() - 10.0 * percent) < 1e-6);
  }
}

}  // namespace
}  // namespace lamina
