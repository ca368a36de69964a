// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The streamer against firmware played by hand, line by line, at times that are set.
#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

using test::kMarlin;
using test::ScriptedPeer;

TEST_F(ScriptedPeer, NeverHasMoreUnderWayThanTheWindow) {
  Streamer streamer(program_, settings());
  begin(streamer);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
  streamer.receive("ok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), line(5));
  streamer.receive("o", 0.2);
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.receive("k\nok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), line(6) + line(7));
  EXPECT_EQ(streamer.status().lines_acknowledged, 3U);
}

TEST_F(ScriptedPeer, KeepsTheReceiveBufferFromOverflowing) {
  StreamSettings narrow = settings();
  narrow.window_bytes = 32;
  narrow.max_line_bytes = 32;
  Streamer streamer(program_, narrow);
  begin(streamer);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2));  // 12 bytes each; a third would make 36
}

TEST_F(ScriptedPeer, CompletesOnlyWhenTheMachineSaysThatItHasEveryLine) {
  Streamer streamer(program_, settings());
  begin(streamer);
  for (int i = 0; i < 10; ++i) streamer.receive("ok\n", 0.1 * i);
  EXPECT_EQ(streamer.status().lines_acknowledged, 10U);
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  streamer.takeOutput();
  streamer.receive("Resend: 10\nok\n", 1.5);  // one of the oks was for something else
  EXPECT_EQ(streamer.takeOutput(), line(10));
  streamer.receive("ok\n", 1.6);
  EXPECT_EQ(streamer.takeOutput(), frameLine(12, "M105"));
  streamer.receive("Resend: 11\nok\n", 1.7);
  EXPECT_EQ(streamer.status().state, PackmlState::Completing);
  EXPECT_EQ(streamer.takeOutput(), "M400\n");
  streamer.receive("ok\n", 1.8);
  EXPECT_EQ(streamer.status().state, PackmlState::Complete);
}

TEST_F(ScriptedPeer, SendsFromTheLineAskedForOnceTheOthersAreAnswered) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("ok\nError:checksum mismatch, Last Line: 1\nResend: 2\nok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), "");  // 3 and 4 are still to be refused
  streamer.receive("Resend: 2\nok\nResend: 2\nok\n", 0.11);
  EXPECT_EQ(streamer.takeOutput(), line(2) + line(3) + line(4) + line(5));
  EXPECT_EQ(streamer.status().resends, 1U);
}

TEST_F(ScriptedPeer, SendsAgainWhenFirmwareHasDiscardedTheOthers) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("Resend: 1\nok\n", 0.1);
  EXPECT_NEAR(streamer.nextDeadline(), 0.15, 1e-9);
  streamer.elapse(streamer.nextDeadline());
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
}

TEST_F(ScriptedPeer, AsksWhichLineTheMachineHasWhenOksAreLost) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  EXPECT_NEAR(streamer.nextDeadline(), 2.5, 1e-9);
  streamer.elapse(2.5);
  EXPECT_EQ(streamer.takeOutput(), frameLine(6, "M105"));
  streamer.receive("Resend: 5\nok\n", 2.6);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
  EXPECT_EQ(streamer.status().lines_acknowledged, 4U);
}

TEST_F(ScriptedPeer, FollowsTheNumbersOfAdvancedOks) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("ok N3 P15 B3\n", 0.1);  // those of 1 and 2 were lost
  EXPECT_EQ(streamer.status().lines_acknowledged, 3U);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7));
}

TEST_F(ScriptedPeer, WaitsPatientlyWhileTheMachineIsBusy) {
  const auto heating = StreamableProgram::fromText("heating", "M109 S200\n");
  Streamer streamer(heating, settings());
  begin(streamer);
  for (double now = 2.0; now < 600.0; now += 2.0) {
    streamer.elapse(now);
    streamer.receive("echo:busy: processing\n", now);
  }
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  EXPECT_EQ(streamer.takeOutput(), frameLine(1, "M109 S200"));
}

TEST_F(ScriptedPeer, SaysWhatToDoWithAMachineThatHasHalted) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("Error:Heating failed, system stopped! Heater_ID: bed\n", 1.0);
  for (double now = 1.5; now < 12.0; now += 0.5) streamer.elapse(now);
  EXPECT_EQ(streamer.status().failure.message,
            "the machine halted: \"Error:Heating failed, system stopped! Heater_ID: bed\"; line 0 of 10 was "
            "the last "
            "acknowledged; a halted machine does not confirm the safe stop: see that it cools, and reset it");
}

TEST_F(ScriptedPeer, GivesUpWhenNobodyAnswers) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  for (double now = 0.5; now <= 10.0; now += 0.5) streamer.elapse(now);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::TimedOut);
}

TEST_F(ScriptedPeer, RefusesFirmwareThatDoesNotCheckLineNumbers) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  for (double now = 0.5; now <= 25.0; now += 0.5) {
    streamer.receive("ok\n", now);
    streamer.elapse(now);
  }
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
}

TEST_F(ScriptedPeer, GreetsAgainWhenTheMachineHasJustBooted) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  streamer.takeOutput();
  streamer.receive("start\necho:Marlin 2.1\n", 1.5);
  EXPECT_EQ(streamer.takeOutput(), "M115\n");
  streamer.receive(kMarlin, 1.6);
  EXPECT_EQ(streamer.takeOutput(), "N0 M110 N0*125\nN2 M105*37\n");
}

TEST_F(ScriptedPeer, KnowsWhoAnswersBeforeItSendsAnythingElse) {
  Streamer streamer(program_, settings());
  begin(streamer);
  EXPECT_EQ(streamer.status().firmware_name, "Marlin 2.1.2 (Nov 22 2026)");
}

TEST_F(ScriptedPeer, LeavesFirmwareThatSpeaksOtherwiseAlone) {
  for (const std::string name : {"Klipper", "RepRapFirmware for Duet 3 MB6HC", "Grbl 1.1h", "Smoothieware"}) {
    StreamSettings insisting = settings();
    insisting.firmware = "marlin";
    Streamer streamer(program_, insisting);
    streamer.start(0.0);
    streamer.takeOutput();
    streamer.receive("FIRMWARE_NAME: " + name + " FIRMWARE_VERSION: 3.5\nok\n", 0.1);
    EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
    EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
    EXPECT_NE(streamer.status().failure.message.find("\"" + name + "\""), std::string::npos);
    EXPECT_EQ(streamer.takeOutput(), "") << "its heaters are none of ours";
  }
}

TEST_F(ScriptedPeer, WaitsForAMachineThatHeatsForAnotherSenderAndStopsNothingThere) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  EXPECT_EQ(streamer.takeOutput(), "M115\n");
  for (double now = 1.0; now < 120.0; now += 1.0) {
    streamer.receive(" T:80.0 /200.0 B:20.0 /0.0 @:127 W:?\n", now);
    streamer.elapse(now);
    EXPECT_EQ(streamer.status().state, PackmlState::Starting);
    EXPECT_EQ(streamer.takeOutput(), "");
  }
  streamer.abort({ErrorCode::Cancelled, "enough"}, 120.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.takeOutput(), "");
}

TEST_F(ScriptedPeer, AbortsWhenAMachineWhoseGreetingWasNotSeenCountsAnew) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("ok\nok\nok\n", 0.1);
  streamer.takeOutput();
  streamer.receive("Resend: 1\nok\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), frameLine(9, "M105")) << "noise may have changed the number";
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  streamer.receive("Resend: 1\nok\n", 0.3);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::DeviceError);
  EXPECT_NE(streamer.status().failure.message.find("asks for line 1, which it has taken"), std::string::npos);
}

TEST_F(ScriptedPeer, FollowsARequestWhoseNumberNoiseHadChanged) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("ok\nok\nok\n", 0.1);
  streamer.takeOutput();
  streamer.receive("Resend: 1\nok\n", 0.2);
  streamer.takeOutput();
  streamer.receive("Resend: 5\nok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
}

TEST_F(ScriptedPeer, AbortsAtAGreetingBehindStrayBytes) {
  for (const std::string greeting : {"\xffstart", "\x01\x80start", "Grbl 1.1h ['$' for help]",
                                     "RepRapFirmware for Duet 3 MB6HC is up and running."}) {
    Streamer streamer(program_, settings());
    begin(streamer);
    streamer.receive("ok\n" + greeting + "\n", 1.0);
    EXPECT_EQ(streamer.status().failure.code, ErrorCode::DeviceError) << greeting;
  }
}

TEST_F(ScriptedPeer, HasOneLineUnderWayOnALossyLink) {
  StreamSettings lossy = settings();
  lossy.link = LinkKind::Lossy;
  Streamer streamer(program_, lossy);
  begin(streamer);
  EXPECT_EQ(streamer.takeOutput(), line(1));
  streamer.receive("ok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), line(2));
}

TEST_F(ScriptedPeer, TakesAnOkForALinesWhereFirmwareSaysNoneAfterARequest) {
  StreamSettings lossy = settings();
  lossy.link = LinkKind::Lossy;
  Streamer streamer(program_, lossy);
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("Resend: 1\n", 0.1);
  streamer.elapse(streamer.nextDeadline());
  EXPECT_EQ(streamer.takeOutput(), line(1));
  streamer.receive("ok\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), line(2)) << "without waiting for a probe";
}

TEST_F(ScriptedPeer, CountsCommandsThatWereNotDone) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("ok\necho: cold extrusion prevented\nok\necho:Unknown command: \"G1 X3\"\nok\n", 0.1);
  EXPECT_EQ(streamer.status().commands_not_done, 2U);
  EXPECT_EQ(streamer.status().first_not_done, "echo: cold extrusion prevented");
  streamer.receive("Resend: 3\nok\n",
                   0.2);  // what was unknown was a line without its number, and is sent again
  EXPECT_EQ(streamer.status().commands_not_done, 1U);
}

// Boards without AUTO_REPORT_TEMPERATURES, or with BABYSTEPPING off.
TEST_F(ScriptedPeer, CountsNoCommandOfItsOwnThatTheMachineDoesNotKnow) {
  StreamSettings reporting;
  reporting.link = LinkKind::Reliable;
  Streamer streamer(program_, reporting);
  streamer.start(0.0);
  streamer.receive(kMarlin, 0.0);
  streamer.receive("ok\nError:Line Number is not Last Number+1, Last Line: 0\nResend: 1\nok\n", 0.0);
  streamer.takeOutput();
  streamer.receive("echo:Unknown command: \"M155 S1\"\nok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
  streamer.change({LiveSetting::Babystep, 0.02}, 0.2);
  streamer.receive("ok\nok\nok\nok\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "M290 Z0.02\n");
  streamer.receive("echo:Unknown command: \"M290 Z0.02\"\nok\n", 0.4);
  EXPECT_EQ(streamer.status().message, "echo:Unknown command: \"M290 Z0.02\"");
  streamer.receive("ok\nok\nok\nok\n", 0.5);
  EXPECT_EQ(streamer.status().lines_acknowledged, 8U);
  EXPECT_EQ(streamer.status().commands_not_done, 0U);
}

TEST_F(ScriptedPeer, PausesAndResumesWhenTheMachineAsksForIt) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.receive("//action:out_of_filament\nok\nok\nok\nok\n", 0.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_EQ(streamer.status().message, "//action:out_of_filament");
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.receive("// action:resume\n", 60.0);
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
}

TEST_F(ScriptedPeer, GoesOnOnlyWhereTheMachineItselfHadPaused) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.takeOutput();
  streamer.pause(0.1);
  streamer.receive("ok\nok\nok\nok\n//action:resume\n", 0.2);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
}

TEST_F(ScriptedPeer, EndsWhenTheMachineAsksForItOrHalts) {
  for (const std::string message :
       {"// action:cancel", "//action:kill", "//action:poweroff", "fatal: heater 1 disconnected"}) {
    Streamer streamer(program_, settings());
    begin(streamer);
    streamer.takeOutput();
    streamer.receive(message + "\n", 1.0);
    EXPECT_EQ(streamer.status().state, PackmlState::Aborting) << message;
    EXPECT_NE(streamer.status().failure.message.find(message), std::string::npos);
    const bool is_asked = message == "// action:cancel";  // all others are halts
    EXPECT_EQ(streamer.status().failure.code, is_asked ? ErrorCode::Cancelled : ErrorCode::Rejected)
        << message;
  }
}

TEST_F(ScriptedPeer, AbortsWhenTheMachineIsResetDuringAJob) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("ok\nok\nstart\n", 1.0);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::DeviceError);
  EXPECT_NE(streamer.status().failure.message.find("line 2 of 10 was the last acknowledged"),
            std::string::npos);
}

TEST_F(ScriptedPeer, AbortsWhenTheMachineHalts) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive("Error:Thermal Runaway, system stopped! Heater_ID: 0\n", 1.0);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
  EXPECT_NE(streamer.status().failure.message.find("Thermal Runaway"), std::string::npos);
}

TEST_F(ScriptedPeer, AbortsWhenTheMachineAsksForLinesThatNeverWere) {
  Streamer streamer(program_, settings());
  begin(streamer);
  for (int i = 0; i < 10; ++i) streamer.receive("Resend: 4711\nok\n", 0.1 * i);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
}

TEST_F(ScriptedPeer, AbortsWhenALineIsRefusedForEver) {
  Streamer streamer(program_, settings());
  begin(streamer);
  for (int i = 1; i < 1000 && streamer.status().state == PackmlState::Execute; ++i) {
    streamer.receive("Resend: 1\nok\n", i);
    streamer.elapse(i + 0.5);
  }
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
}

TEST_F(ScriptedPeer, HoldsAfterTheLinesUnderWay) {
  Streamer streamer(program_, settings());
  EXPECT_FALSE(streamer.pause(0.0));
  begin(streamer);
  streamer.takeOutput();
  EXPECT_FALSE(streamer.resume(0.1));
  EXPECT_TRUE(streamer.pause(0.1));
  EXPECT_EQ(streamer.status().state, PackmlState::Holding);
  streamer.receive("ok\nok\nok\n", 0.2);
  EXPECT_EQ(streamer.status().state, PackmlState::Holding);
  streamer.receive("ok\n", 0.3);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_EQ(streamer.takeOutput(), "");
  EXPECT_TRUE(streamer.resume(100.0));
  EXPECT_EQ(streamer.takeOutput(), line(5) + line(6) + line(7) + line(8));
}

TEST_F(ScriptedPeer, PassesThroughLegalStatesOnly) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.pause(0.1);
  streamer.resume(0.2);
  streamer.pause(0.3);
  streamer.receive("ok\nok\nok\nok\n", 0.4);
  streamer.resume(0.5);
  streamer.abort({ErrorCode::Cancelled, "enough"}, 0.6);
  streamer.disconnect("lost the link", 0.7);
  streamer.elapse(100.0);
  PackmlState before = PackmlState::Idle;
  for (const PackmlState state : streamer.takeStateChanges()) {
    EXPECT_TRUE(isLegalTransition(before, state)) << toString(before) << " to " << toString(state);
    before = state;
  }
  EXPECT_EQ(before, PackmlState::Aborted);
}

TEST_F(ScriptedPeer, ReportsTemperaturesPositionsAndWarnings) {
  Streamer streamer(program_, settings());
  begin(streamer);
  streamer.receive(" T:201.0 /210.0 B:59.0 /60.0 @:0\nX:1.0 Y:2.0 Z:3.0 E:4.0 Count X:0\nError:SD full\n",
                   0.1);
  EXPECT_DOUBLE_EQ(streamer.status().temperatures->nozzle_c, 201.0);
  EXPECT_DOUBLE_EQ(streamer.status().position->y, 2.0);
  EXPECT_EQ(streamer.status().message, "Error:SD full");
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
}

}  // namespace
}  // namespace lamina
