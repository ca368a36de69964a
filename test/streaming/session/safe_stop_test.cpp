// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The streamer against firmware played by hand, line by line, at times that are set.
#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

using test::kMarlin;
using test::ScriptedPeer;

TEST_F(ScriptedPeer, StopsSafelyWhenTheMachineFallsSilent) {
  Streamer streamer(program_, settings());
  begin(streamer);
  for (double now = 1.0; now < 60.5; now += 0.5) streamer.elapse(now);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::TimedOut);
  EXPECT_NE(streamer.takeOutput().find("M108\nM410\nM104 S0\nM140 S0\n"), std::string::npos);
  for (double now = 60.5; now < 71.0; now += 0.5) streamer.elapse(now);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_NE(streamer.status().failure.message.find("did not confirm the safe stop: it may still move and be "
                                                   "hot, look after it"),
            std::string::npos);
}

TEST_F(ScriptedPeer, TurnsOffAllThatTheProgramHasTurnedOn) {
  const auto program = StreamableProgram::fromText(
      "busy", "M3 S100\nM104 T0 S200\nM104 T1 S210\nM141 S40\nM106 S255\nM106 P1 S9\nM8\nG1 X1\n");
  StreamSettings settings = this->settings();
  settings.temperature_interval_s = 1;
  settings.window_lines = 8;
  Streamer streamer(program, settings);
  streamer.start(0.0);
  streamer.receive("ok\nok\nResend: 1\nok\nok\n", 0.1);
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  EXPECT_EQ(streamer.takeOutput(),
            "M108\nM410\nM5\nM104 S0\nM140 S0\n" + frameLine(1009, "M110 N1009") + frameLine(1011, "M105"))
      << "laser and heat first";
  std::string stop;
  for (int line = 1010; line < 1030; ++line) {
    streamer.receive("Resend: " + std::to_string(line) + "\nok\n", 1.0 + 0.1 * (line - 1009));
    stop += streamer.takeOutput();
  }
  for (const char* command :
       {"M410", "M5", "M104 S0", "M140 S0", "M104 T1 S0", "M141 S0", "M107", "M106 P1 S0", "M9", "M155 S0"})
    EXPECT_NE(stop.find(std::string(" ") + command + "*"), std::string::npos) << command << " in\n" << stop;
}

TEST_F(ScriptedPeer, WaitsForEveryHeaterToBeOff) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  streamer.receive("ok\nok\nok\nok\nok\nok\nok\nResend: 1006\nok\n", 1.1);
  streamer.receive("ok\nok\nok\n", 1.2);
  streamer.receive("Resend: 1009\nok\n", 1.3);
  streamer.receive("ok T:180.0 /0.0 B:60.0 /0.0 T0:180.0 /0.0 T1:170.0 /210.0 @:0 B@:0\n", 1.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  streamer.receive("ok T:180.0 /0.0 B:60.0 /0.0 T0:180.0 /0.0 T1:170.0 /0.0 @:0 B@:0\n", 1.5);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
}

/// Begins a stop of the ten lines, of which one is sent, and takes it to its last question.
void drain(Streamer& streamer) {
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  streamer.receive("ok\nok\nok\nok\nok\nok\nok\nResend: 1006\nok\n", 1.1);
  streamer.receive("ok\nok\nok\n", 1.2);
  streamer.takeOutput();
  streamer.receive("Resend: 1009\nok\n", 1.3);
  EXPECT_EQ(streamer.takeOutput(), "M105\n");
}

TEST_F(ScriptedPeer, SwitchesOffToolsThatAreStillHeatedByTheirNumbers) {
  Streamer streamer(program_, settings());
  begin(streamer);
  drain(streamer);
  streamer.receive("ok T:180.0 /0.0 B:60.0 /0.0 T0:180.0 /0.0 T1:170.0 /210.0 @:0 B@:0\n", 1.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  EXPECT_EQ(streamer.takeOutput(), "M104 T0 S0\nM104 T1 S0\n");
}

TEST_F(ScriptedPeer, TakesNoReportThatItHasNotAskedForForTheEndOfAStop) {
  Streamer streamer(program_, settings());
  begin(streamer);
  drain(streamer);
  streamer.receive(" T:20.0 /0.0 B:20.0 /0.0 @:0 B@:0\n", 1.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting) << "the stop may wait behind long motions";
  streamer.receive("ok T:20.0 /0.0 B:20.0 /0.0 @:0 B@:0\n", 1.5);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
}

TEST_F(ScriptedPeer, TurnsHeatersOffInLinesTheMachineConfirms) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  EXPECT_EQ(streamer.takeOutput(),
            "M108\nM410\nM104 S0\nM140 S0\n" + frameLine(1005, "M110 N1005") + frameLine(1007, "M105"));
  streamer.receive("ok\nok\nok\nok\nok\nok\nok\nResend: 1006\nok\n", 1.1);
  EXPECT_EQ(streamer.takeOutput(),
            frameLine(1006, "M410") + frameLine(1007, "M104 S0") + frameLine(1008, "M140 S0"));
  streamer.receive("ok\nResend: 1007\nok\n", 1.2);
  streamer.elapse(1.3);
  EXPECT_EQ(streamer.takeOutput(), frameLine(1007, "M104 S0") + frameLine(1008, "M140 S0"));
  streamer.receive("ok\nok\n", 1.4);
  EXPECT_EQ(streamer.takeOutput(), frameLine(1010, "M105"));
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  streamer.receive("Resend: 1009\nok\n", 1.5);
  EXPECT_EQ(streamer.takeOutput(), "M105\n");
  streamer.receive("ok T:180.0 /200.0 B:60.0 /60.0\n", 1.6);  // the lines wait behind others
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  streamer.elapse(4.2);
  EXPECT_EQ(streamer.takeOutput(), "M105\n");
  streamer.receive("ok T:180.0 /0.0 B:60.0 /0.0\n", 4.3);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.message, "enough");
}

TEST_F(ScriptedPeer, LeavesHeatersOnIfAskedTo) {
  StreamSettings keeping = settings();
  keeping.keep_heaters_on = true;
  Streamer streamer(program_, keeping);
  begin(streamer);
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  streamer.receive("Resend: 1006\nok\n", 1.1);
  const std::string sent = streamer.takeOutput();
  EXPECT_NE(sent.find("M410"), std::string::npos);
  EXPECT_EQ(sent.find("S0"), std::string::npos);
}

TEST_F(ScriptedPeer, SaysThatTheMachineWasNotStoppedWhenTheLinkStaysLost) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("ok\n", 0.5);
  streamer.disconnect("lost the link", 1.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  EXPECT_DOUBLE_EQ(streamer.nextDeadline(), 11.0);
  streamer.elapse(11.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Disconnected);
  EXPECT_EQ(streamer.status().failure.message,
            "lost the link; line 1 of 10 was the last acknowledged; the link did not come back, so that the "
            "machine was not commanded to stop: look after it");
}

TEST_F(ScriptedPeer, StopsTheMachineOnceTheLinkIsBack) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("ok\n", 0.5);
  streamer.disconnect("lost the link", 1.0);
  EXPECT_TRUE(streamer.isOffline());
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.reconnect(9.0);
  EXPECT_FALSE(streamer.isOffline());
  EXPECT_EQ(streamer.takeOutput().find("M108\nM410\nM104 S0\nM140 S0\n"), 0U);
  streamer.receive("Resend: 1007\nok\nok\nok\nok\n", 9.1);
  streamer.receive("Resend: 1010\nok\n", 9.2);
  streamer.receive("ok T:180.0 /0.0 B:60.0 /0.0\n", 9.3);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.message, "lost the link; line 1 of 10 was the last acknowledged");
}

TEST_F(ScriptedPeer, WaitsForAMachineThatIsBusyWhenItIsToStop) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  for (double now = 2.0; now < 100.0; now += 2.0) {
    streamer.elapse(now);
    streamer.receive("echo:busy: processing\n", now);
  }
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  for (double now = 100.0; now < 111.0; now += 2.0) streamer.elapse(now);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
}

TEST_F(ScriptedPeer, DoesNotTakeAnUnknownTargetForAColdHeater) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  streamer.receive("Resend: 1006\nok\nok\nok\nok\n", 1.1);
  streamer.receive("Resend: 1009\nok\n", 1.2);
  streamer.receive("ok T:200.0 B:60.0\n", 1.3);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  streamer.receive("ok T:200.0 B:60.0 /0\n", 1.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
}

}  // namespace
}  // namespace lamina
