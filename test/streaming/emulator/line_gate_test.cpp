// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/line_gate.hpp"

#include <gtest/gtest.h>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {
namespace {

std::string framed(std::uint64_t number, const std::string& command) {
  std::string line = frameLine(number, command);
  line.pop_back();
  return line;
}

TEST(LineGate, TakesLinesInOrder) {
  LineGate gate;
  EXPECT_EQ(gate.take(framed(1, "G28")).command, "G28");
  EXPECT_EQ(gate.take(framed(2, "G1 X1 Y2")).command, "G1 X1 Y2");
  EXPECT_EQ(gate.lastNumber(), 2U);
}

TEST(LineGate, TakesNoLineTwiceAndLeavesNoneOut) {
  LineGate gate;
  gate.take(framed(1, "G28"));
  EXPECT_NE(gate.take(framed(1, "G28")).refusal, "");
  EXPECT_NE(gate.take(framed(3, "G28")).refusal, "");
  EXPECT_EQ(gate.lastNumber(), 1U);
}

TEST(LineGate, RefusesEveryChangeOfOneCharacter) {
  const std::string good = framed(1, "G1 X12.5");
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (char other = ' '; other <= '~'; ++other) {
      if (other == good[at]) continue;
      std::string bad = good;
      bad[at] = other;
      LineGate gate;
      const GatedLine taken = gate.take(bad);
      EXPECT_TRUE(!taken.refusal.empty() || taken.command == "G1 X12.5") << bad;
    }
  }
}

TEST(LineGate, SetsTheNumberByM110) {
  LineGate gate;
  EXPECT_EQ(gate.take(framed(0, "M110 N41")).refusal, "");
  EXPECT_EQ(gate.take(framed(42, "G28")).refusal, "");
}

TEST(LineGate, TakesLinesWithoutNumberUnlessTheyHaveAChecksum) {
  LineGate gate;
  EXPECT_EQ(gate.take("M105").command, "M105");
  EXPECT_NE(gate.take("M105*36").refusal, "");
}

}  // namespace
}  // namespace lamina
