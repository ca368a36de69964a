// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Waits of a machine for a person, played by hand.
#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

using test::ScriptedPeer;
using PersonWaitTest = ScriptedPeer;

// Marlin's M108 ends the wait of M0 or M600, if its EMERGENCY_PARSER reads it before what waits behind; the
// ok to M108 itself comes in its turn, after those of the lines that were sent before.
TEST_F(PersonWaitTest, EndsTheWaitOfAMachineThatHearsMeanwhile) {
  for (const char* firmware : {"marlin", kAnyFirmware}) {
    StreamSettings spoken = settings();
    spoken.firmware = firmware;
    Streamer streamer(program_, spoken);
    begin(streamer, "Cap:EMERGENCY_PARSER:1\n");
    streamer.receive("ok\necho:busy: processing\n", 0.1);
    EXPECT_EQ(streamer.status().message, "");
    EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4) + line(5));
    streamer.receive("echo:busy: paused for user\n", 2.1);
    EXPECT_EQ(streamer.status().state, PackmlState::Held) << firmware;
    EXPECT_EQ(streamer.status().wait, streamer.status().message);
    EXPECT_EQ(streamer.status().message,
              "the machine waits for a person: \"echo:busy: paused for user\"; resume makes it go on (M108)");
    streamer.receive("echo:busy: paused for user\n", 4.1);
    EXPECT_EQ(streamer.takeOutput(), "");
    EXPECT_TRUE(streamer.resume(5.0));
    EXPECT_EQ(streamer.takeOutput(), "M108\n");
    EXPECT_EQ(streamer.status().wait, "");
    EXPECT_EQ(streamer.status().state, PackmlState::Execute);
    streamer.receive("ok\nok\nok\nok\n", 5.1);
    EXPECT_EQ(streamer.takeOutput(), line(6) + line(7) + line(8));
    EXPECT_EQ(streamer.status().lines_acknowledged, 5U);
    streamer.receive("ok\n", 5.2);
    EXPECT_EQ(streamer.takeOutput(), line(9));
    EXPECT_EQ(streamer.status().lines_acknowledged, 5U) << "that was M108's";
  }
}

// A machine that has read the last line may have to be told to end its wait, too.
TEST_F(PersonWaitTest, EndsTheWaitOfTheLastLine) {
  Streamer streamer(program_, settings());
  begin(streamer, "Cap:EMERGENCY_PARSER:1\n");
  for (int i = 0; i < 10; ++i) streamer.receive("ok\n", 0.1 * i);
  streamer.takeOutput();
  streamer.receive("Resend: 11\nok\n", 1.0);
  ASSERT_EQ(streamer.status().state, PackmlState::Completing);
  EXPECT_EQ(streamer.takeOutput(), "M400\n");
  EXPECT_FALSE(streamer.resume(1.5)) << "nothing waits";
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.receive("echo:busy: paused for user\n", 3.0);
  EXPECT_NE(streamer.status().wait.find("resume makes it go on"), std::string::npos);
  EXPECT_TRUE(streamer.resume(4.0));
  EXPECT_EQ(streamer.takeOutput(), "M108\n");
  EXPECT_EQ(streamer.status().wait, "");
  streamer.receive("ok\nok\n", 4.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Complete);
}

TEST_F(PersonWaitTest, WaitsForAPersonAtAMachineThatHearsNothingMeanwhile) {
  Streamer streamer(program_, settings());
  begin(streamer, "Cap:EMERGENCY_PARSER:0\n");
  streamer.takeOutput();
  streamer.receive("echo:busy: paused for user\n", 2.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_NE(streamer.status().message.find("press its button"), std::string::npos);
  EXPECT_NE(streamer.status().message.find("EMERGENCY_PARSER"), std::string::npos);
  EXPECT_TRUE(streamer.resume(3.0));
  EXPECT_EQ(streamer.takeOutput(), "") << "it would lie behind what waits";
  streamer.receive("echo:busy: paused for user\n", 4.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Held) << "it still waits";
  streamer.receive("ok\n", 60.0);  // somebody has pressed it
  EXPECT_EQ(streamer.status().wait, "");
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  EXPECT_EQ(streamer.takeOutput(), line(5));
}

TEST_F(PersonWaitTest, StaysHeldAfterAWaitIfAPersonHeldItBefore) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  EXPECT_TRUE(streamer.pause(1.0));
  EXPECT_EQ(streamer.status().state, PackmlState::Holding);
  streamer.receive("echo:busy: paused for user\n", 2.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Held)
      << "the lines under way wait behind the one that waits";
  streamer.receive("ok\nok\nok\nok\n", 3.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_EQ(streamer.takeOutput(), "");
  EXPECT_TRUE(streamer.resume(4.0));
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
}

}  // namespace
}  // namespace lamina
