// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/plain_command.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(PlainCommand, IsACommandWithWordsOfNumbers) {
  for (const char* line : {"G28", "G1 X1.5 Y-2 E.3 F1200", "  g1x1y2", "M104 S200 ; hot", "N12 G28 X Y*44",
                           "G92 E0\r", "M84 X Y E"})
    EXPECT_TRUE(isPlainCommand(line)) << line;
}

TEST(PlainCommand, IsNothingThatAnotherTextMayHold) {
  for (const char* line :
       {"", "; a remark", "X1 Y2", "root:$6$SECRET", "games:*:19000", "g1: secret", "M4 secret",
        "M117 secret", "G", "G1 password", "m1key=secret", "T0", "12,13", "{G1: 2}", "G1 X1 (a)"})
    EXPECT_FALSE(isPlainCommand(line)) << line;
}

}  // namespace
}  // namespace lamina
