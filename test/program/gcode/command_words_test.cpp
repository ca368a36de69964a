// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/command_words.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(CommandWords, HaveTheirNumbersWithBlanksAndWithout) {
  for (const char* command : {"M104 T1 S200.5", "M104T1S200.5", "M104 S 200.5 T1"}) {
    EXPECT_EQ(wordValue(command, 'S'), 200.5) << command;
    EXPECT_EQ(wordValue(command, 'T'), 1.0) << command;
    EXPECT_FALSE(wordValue(command, 'P')) << command;
  }
  EXPECT_EQ(wordValue("G1X10.Y-5E2", 'X'), 10.0);
  EXPECT_EQ(wordValue("G1X10.Y-5E2", 'Y'), -5.0) << "an E begins the next word";
  EXPECT_EQ(wordValue("G1X10.Y-5E2", 'E'), 2.0);
}

TEST(CommandWords, AreNotFoundWithinNames) {
  EXPECT_FALSE(wordValue("SET_FAN_SPEED FAN=nozzle", 'S'));
  EXPECT_FALSE(wordValue("M104", 'M')) << "the code itself is none";
  EXPECT_FALSE(wordValue("M18 X", 'X')) << "a flag has no number";
}

}  // namespace
}  // namespace lamina
