// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/unnumbered_commands.hpp"
#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

using test::ScriptedPeer;

TEST_F(ScriptedPeer, ChangesTheJobBetweenTwoLinesWithoutANumber) {
  Streamer streamer(program_, settings());
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, 0.0), kNoJobToChange);
  begin(streamer);
  streamer.takeOutput();
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, 0.1), "");
  EXPECT_EQ(streamer.change({LiveSetting::Babystep, -0.05}, 0.1), "");
  streamer.receive("ok\nok\nok\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), "") << "one line is still under way";
  streamer.receive("ok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "M220 S50\n");
  streamer.receive("ok\n", 0.4);
  EXPECT_EQ(streamer.takeOutput(), "M290 Z-0.05\n");
  EXPECT_EQ(streamer.status().lines_acknowledged, 4U);
  streamer.receive("ok\n", 0.5);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
  EXPECT_EQ(streamer.status().lines_acknowledged, 4U) << "a change is no line of the program";
}

TEST_F(ScriptedPeer, RefusesByNameWhatTheFirmwareHasNot) {
  Streamer streamer(program_, settings());
  begin(streamer);
  EXPECT_EQ(streamer.change({LiveSetting::Spindle, 50.0}, 0.1), "this firmware has no spindle");
  EXPECT_EQ(streamer.change({LiveSetting::Rapid, 50.0}, 0.1), "this firmware has no rapid");
}

TEST_F(ScriptedPeer, AsksWhichLineTheMachineHasWhereAChangeIsNotAnswered) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("ok\nok\nok\nok\n", 0.1);
  streamer.takeOutput();
  EXPECT_EQ(streamer.change({LiveSetting::CancelPart, 2.0}, 0.2), "");
  streamer.receive("ok\nok\nok\nok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "M486 P2\n");
  streamer.elapse(2.9);
  EXPECT_EQ(streamer.takeOutput(), frameLine(10, "M105"));
  EXPECT_EQ(streamer.status().message, "no answer to M486 P2, which may not have been done");
  streamer.receive("Resend: 9\nok\n", 3.0);
  EXPECT_EQ(streamer.takeOutput(), line(9) + line(10));
}

TEST_F(ScriptedPeer, MakesTheChangesBehindOneThatIsNotAnswered) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  EXPECT_EQ(streamer.change({LiveSetting::CancelPart, 2.0}, 0.1), "");
  EXPECT_TRUE(streamer.ask("M119", 0.1));
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, 0.1), "");
  EXPECT_EQ(streamer.change({LiveSetting::Babystep, -0.05}, 0.1), "");
  streamer.receive("ok\nok\nok\nok\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), "M486 P2\n");
  streamer.elapse(2.8);
  EXPECT_EQ(streamer.takeOutput(), frameLine(6, "M105"));
  EXPECT_EQ(streamer.status().message, "no answer to M486 P2, which may not have been done");
  streamer.receive("Resend: 5\nok\n", 2.9);
  EXPECT_EQ(streamer.takeOutput(), "M220 S50\n") << "nobody waits for the question any more";
  streamer.receive("ok\n", 3.0);
  EXPECT_EQ(streamer.takeOutput(), "M290 Z-0.05\n");
  streamer.receive("ok\n", 3.1);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
}

/// Answers until the last two of ten lines are under way.
void beginTheEnd(Streamer& streamer) {
  streamer.takeOutput();
  streamer.receive("ok\nok\nok\nok\n", 0.1);
  streamer.takeOutput();
  streamer.receive("ok\nok\nok\nok\n", 0.2);
}

TEST_F(ScriptedPeer, MakesAChangeThatWaitsWhenTheLastLineIsProvenTaken) {
  Streamer streamer(program_, settings());
  begin(streamer);
  beginTheEnd(streamer);
  EXPECT_EQ(streamer.takeOutput(), line(9) + line(10));
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, 0.3), "");
  streamer.receive("ok\n", 0.4);  // that to the last line is lost
  streamer.elapse(3.0);
  EXPECT_EQ(streamer.takeOutput(), frameLine(12, "M105"));
  streamer.receive("Resend: 11\nok\n", 3.1);
  EXPECT_EQ(streamer.takeOutput(), "M220 S50\n") << "motions are still to be run";
  streamer.receive("ok\n", 3.2);
  EXPECT_EQ(streamer.takeOutput(), frameLine(12, "M105"));
  streamer.receive("Resend: 11\nok\n", 3.3);
  EXPECT_EQ(streamer.takeOutput(), "M400\n");
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 60.0}, 3.4), kNoJobToChange);
}

TEST_F(ScriptedPeer, MakesAChangeThatComesWhileTheLastLineIsBeingProven) {
  Streamer streamer(program_, settings());
  begin(streamer);
  beginTheEnd(streamer);
  streamer.takeOutput();
  streamer.receive("ok\nok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), frameLine(12, "M105"));
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, 0.4), "");
  EXPECT_EQ(streamer.change({LiveSetting::Flow, 90.0}, 0.4), "");
  streamer.receive("Resend: 11\nok\n", 0.5);
  EXPECT_EQ(streamer.takeOutput(), "M220 S50\n");
  streamer.elapse(3.2);  // its answer is lost
  EXPECT_EQ(streamer.takeOutput(), frameLine(12, "M105"));
  EXPECT_EQ(streamer.status().message, "no answer to M220 S50, which may not have been done");
  streamer.receive("Resend: 11\nok\n", 3.3);
  EXPECT_EQ(streamer.takeOutput(), "M221 S90\n");
  streamer.receive("ok\n", 3.4);
  streamer.receive("Resend: 11\nok\n", 3.5);
  streamer.takeOutput();
  EXPECT_EQ(streamer.status().state, PackmlState::Completing);
}

TEST(UnnumberedCommands, AskForRestAgainWhereItsAnswerIsLost) {
  UnnumberedCommands commands;
  EXPECT_TRUE(commands.addRest("M400"));
  commands.addChange("M220 S50");
  EXPECT_FALSE(commands.addRest("M400"));
  EXPECT_EQ(commands.lose(), "no answer to M400, which may not have been done");
  EXPECT_EQ(commands.front(), "M220 S50");
  EXPECT_TRUE(commands.addRest("M400"));
  commands.lose();
  EXPECT_EQ(commands.front(), "M400");
  EXPECT_FALSE(commands.addRest("M400")) << "it waits still";
}

TEST_F(ScriptedPeer, PausesOnceInFrontOfALayer) {
  const auto program =
      StreamableProgram::fromText("layers", ";LAYER:0\nG1 X1\nG1 X2\n;LAYER:1\nG1 X3\nG1 X4\n");
  StreamSettings one = settings();
  one.window_lines = 1;
  Streamer streamer(program, one);
  begin(streamer);
  EXPECT_EQ(streamer.takeOutput(), line(1));
  EXPECT_EQ(streamer.change({LiveSetting::PauseAtLayer, 1.0}, 0.1), "");
  streamer.receive("ok\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), line(2));
  streamer.receive("ok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "");
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_TRUE(streamer.resume(9.0));
  EXPECT_EQ(streamer.takeOutput(), line(3));
  streamer.receive("ok\n", 9.1);
  EXPECT_EQ(streamer.takeOutput(), line(4));
}

}  // namespace
}  // namespace lamina
