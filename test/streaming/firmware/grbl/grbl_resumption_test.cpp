// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_resumption.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include "streaming/emulator/grbl_link.hpp"

#include "lamina/streaming/emulator/grbl/emulated_grbl.hpp"
#include "lamina/streaming/session/streamer.hpp"

namespace lamina {
namespace {

constexpr const char* kModes = "[GC:G1 G54 G17 G21 G90 G94 M5 M9 T0 F600 S0]";

StreamableProgram programOf(const std::string& text) {
  return StreamableProgram::fromText("part", text, test::reliableGrbl());
}

GrblResumption resumed(const std::string& text, std::uint64_t taken, std::uint64_t sent, const GrblAxes& work,
                       const char* modes = kModes) {
  return resumptionOf(programOf(text), {taken, sent, ""}, modes, work);
}

TEST(GrblResumption, IsTheLineAtWhoseEndTheMachineStands) {
  const std::string text = "G90\nG1 X1 F600\nX2\nS500\nM3\nX3\nX4\n";
  EXPECT_EQ(resumed(text, 2, 7, {3.0, 0.0, 0.0}).line, 6U);
  // Speed and spindle may have been taken or not: they are said again.
  const GrblResumption at_two = resumed(text, 2, 7, {2.0, 0.0, 0.0});
  EXPECT_EQ(at_two.line, 3U) << at_two.refusal;
  EXPECT_EQ(resumed(text, 5, 7, {2.0, 0.0, 0.0}).line, 5U) << "which was taken";
}

TEST(GrblResumption, IsRefusedWhereThePlaceDoesNotTell) {
  const std::string there_and_back = "G90\nG1 X1 F600\nX2\nX1\nX3\n";
  EXPECT_NE(resumed(there_and_back, 1, 5, {1.0, 0.0, 0.0}).refusal.find("where 2 of lines 1 to 5 end"),
            std::string::npos);
  EXPECT_EQ(resumed(there_and_back, 4, 5, {1.0, 0.0, 0.0}).line, 4U) << "the first way there is not in doubt";
  EXPECT_NE(resumed(there_and_back, 1, 5, {1.5, 0.0, 0.0}).refusal.find("where 0 of"), std::string::npos);
  const std::string circle = "G90\nG1 X1 F600\nG2 X1 I1\nX3\n";
  EXPECT_NE(resumed(circle, 1, 4, {1.0, 0.0, 0.0}).refusal.find("line 3, 'G2 X1 I1' was run"),
            std::string::npos)
      << resumed(circle, 1, 4, {1.0, 0.0, 0.0}).refusal;
  EXPECT_NE(resumed("G91\nG1 X1 F600\nX1\n", 1, 3, {1.0, 0.0, 0.0}, "[GC:G1 G91 F600]").refusal, "");
}

TEST(GrblResumption, TellsTheEndsOfShortMotionsApart) {
  const std::string steps = "G90\nG1 X0.02 F600\nX0.04\nX0.06\nX0.065\n";
  // As reported by an axis of 80 steps a millimetre: 3 steps are 0.0375 mm.
  EXPECT_EQ(resumed(steps, 1, 4, {0.038, 0.0, 0.0}).line, 3U);
  EXPECT_EQ(resumed(steps, 1, 4, {0.020, 0.0, 0.0}).line, 2U) << "another ends 0.02 mm further";
  EXPECT_NE(resumed(steps, 1, 4, {0.030, 0.0, 0.0}).refusal.find("where 2 of lines 1 to 4 end"),
            std::string::npos);
  EXPECT_NE(resumed(steps, 1, 5, {0.060, 0.0, 0.0}).refusal.find("where 2 of lines 1 to 5 end"),
            std::string::npos);
  EXPECT_NE(resumed(steps, 1, 4, {0.081, 0.0, 0.0}).refusal.find("where 0 of"), std::string::npos);
}

TEST(GrblResumption, IsRefusedAfterAReset) {
  const char* forgotten = "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]";
  const std::string refusal = resumed("G90\nG1 X1 F600\nX0\n", 2, 3, {0.0, 0.0, 0.0}, forgotten).refusal;
  EXPECT_NE(refusal.find("has forgotten its feed"), std::string::npos) << refusal;
}

/// A machine at which one streamer after the other speaks.
class LivingGrbl {
 public:
  void connect(Streamer& streamer, double until_s) {
    streamer.start(now);
    while (now < until_s && !isFinal(streamer.status().state)) {
      const std::string to_machine = streamer.takeOutput();
      if (!to_machine.empty()) machine.receive(to_machine, now);
      const std::string to_host = machine.takeOutput();
      if (!to_host.empty()) {
        streamer.receive(to_host, now);
        continue;
      }
      now = std::min(std::max(now + 1e-4, std::min(streamer.nextDeadline(), machine.nextDeadline())),
                     now + 1.0);
      machine.elapse(now);
      streamer.elapse(now);
    }
  }

  /// Asks until the offset of the work is to be told in so many reports, as in one of thirty.
  void tellOffsetIn(int reports) {
    const auto tellsIt = [this] {
      machine.receive("?", now);
      return machine.takeOutput().find("WCO") != std::string::npos;
    };
    while (!tellsIt()) {
    }
    for (int asked = 0; asked < 30 - reports; ++asked) EXPECT_FALSE(tellsIt());
  }

  std::vector<std::string> executed;
  EmulatedGrbl machine{
      EmulatedGrblSettings{}, {}, [this](const std::string& line) { executed.push_back(line); }};
  double now = 0.0;
};

// Killed at any time, with the head of a line left behind, and gone on with by the machine's place.
TEST(GrblResumption, GoesOnWithEachLineOnce) {
  std::string text = "G21\nG90\nG1 F3000\n";
  std::vector<std::string> lines = {"G21", "G90", "G1 F3000"};
  for (int i = 1; i <= 300; ++i) {
    text += "X" + std::to_string(i) + " Y" + std::to_string(i % 7) + "\n";
    lines.push_back("X" + std::to_string(i) + " Y" + std::to_string(i % 7));
  }
  for (double death = 1.0; death < 6.0; death += 0.37) {
    LivingGrbl grbl;
    auto first = std::make_unique<Streamer>(programOf(text), test::reliableGrbl());
    grbl.connect(*first, death);
    const StreamStatus left = first->status();
    ASSERT_EQ(left.state, PackmlState::Execute);
    first.reset();
    grbl.machine.receive("X1", grbl.now);  // of the next line
    StreamOrder order{
        programOf(text),
        test::reliableGrbl(),
        {},
        {},
        0,
        UnfinishedLines{left.lines_acknowledged - std::min<std::uint64_t>(left.lines_acknowledged, 8),
                        left.lines_sent + 20, ""},
        0};
    Streamer second(order);
    grbl.connect(second, 1e4);
    EXPECT_EQ(second.status().state, PackmlState::Complete)
        << death << ": " << second.status().failure.message;
    EXPECT_EQ(grbl.executed, lines) << death;
  }
}

// grbl reports Idle in a dwell, and runs what stands behind it before it answers a question.
TEST(GrblResumption, LooksForThePlaceOnceWhatWasSentHasRun) {
  const std::string text = "G21\nG90\nG1 X10 F3000\nG4 P5\nG91\nG1 X1\nM5\n";
  LivingGrbl grbl;
  auto first = std::make_unique<Streamer>(programOf(text), test::reliableGrbl());
  grbl.connect(*first, 2.0);
  ASSERT_EQ(first->status().lines_sent, 7U);
  ASSERT_EQ(first->status().lines_acknowledged, 3U) << "it dwells";
  first.reset();
  grbl.tellOffsetIn(2);  // while it dwells
  Streamer second(
      StreamOrder{programOf(text), test::reliableGrbl(), {}, {}, 0, UnfinishedLines{0, 7, ""}, 0});
  grbl.connect(second, 1e4);
  EXPECT_EQ(second.status().state, PackmlState::Complete) << second.status().failure.message;
  EXPECT_EQ(std::count(grbl.executed.begin(), grbl.executed.end(), "G1 X1"), 1);
  EXPECT_NEAR(grbl.machine.position().x(), 11.0, 1e-9) << "mm: once to 10, and once 1 on";
}

TEST(GrblResumption, IsNoneOfAMachineThatGreets) {
  StreamOrder order{
      programOf("G90\nG1 X1 F600\n"), test::reliableGrbl(), {}, {}, 0, UnfinishedLines{1, 2, ""}, 0};
  Streamer streamer(order);
  streamer.start(0.0);
  EXPECT_EQ(streamer.takeOutput().find("Z\n"), 0U);
  streamer.receive("\r\nGrbl 1.1h ['$' for help]\r\n", 0.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_NE(streamer.status().failure.message.find("was reset, as by opening its port"), std::string::npos);
}

}  // namespace
}  // namespace lamina
