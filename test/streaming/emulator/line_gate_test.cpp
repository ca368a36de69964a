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

TEST(LineGate, RunsNoCommandOfALineOfWhichOneBitWasFlipped) {
  const std::string good = framed(1, "G1 X12.5");
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ (1 << bit));
      LineGate gate;
      const GatedLine taken = gate.take(bad);
      const bool is_command =
          std::string_view("GMT").find(taken.command.substr(0, 1)) != std::string_view::npos;
      EXPECT_TRUE(!taken.refusal.empty() || taken.command == "G1 X12.5" || !is_command) << bad;
    }
  }
}

TEST(LineGate, SetsTheNumberByM110) {
  LineGate gate;
  EXPECT_EQ(gate.take(framed(0, "M110 N41")).refusal, "");
  EXPECT_EQ(gate.take(framed(42, "G28")).refusal, "");
}

TEST(LineGate, TakesLinesWithoutNumberAsMarlinDoes) {
  LineGate gate;
  EXPECT_EQ(gate.take("M105").command, "M105");
  EXPECT_EQ(gate.take(" G1 X99.980 Y100.046 F6000*127").command, "G1 X99.980 Y100.046 F6000");
  EXPECT_EQ(gate.lastNumber(), 0U);
}

TEST(LineGate, RefusesALineWhoseNumberWasCutOff) {
  LineGate gate;
  EXPECT_NE(gate.take("N").refusal, "");
  EXPECT_NE(gate.take("N1 G2").refusal, "");
  EXPECT_EQ(gate.lastNumber(), 0U);
}

TEST(LineGate, KnowsWhereLinesCountFrom) {
  LineGate gate;
  gate.take("N70 M110 N70*125");
  EXPECT_EQ(gate.firstNumber(), 70U);
  gate.take(frameLine(71, "G28"));
  EXPECT_EQ(gate.lastNumber(), 71U);
  EXPECT_EQ(gate.firstNumber(), 70U);
}

TEST(LineGate, TakesAwayWhatBackspacesReach) {
  EXPECT_EQ(withoutErased("N1 G1 X\b2"), "N1 G1 2");
  EXPECT_EQ(withoutErased("M1\b\b\b\bM115"), "M115");
  EXPECT_EQ(withoutErased("\b"), "");
}

}  // namespace
}  // namespace lamina
