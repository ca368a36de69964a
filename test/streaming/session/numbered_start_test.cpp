// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a job waits for between the numbering of lines and the first of them.
#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

using test::kMarlin;
using NumberedStart = test::ScriptedPeer;

/// A board that greets while its port is opened gets the question twice. Marlin sets its counter by `M110`
/// when it reads it, and again when it runs it, behind all that was asked before.
TEST_F(NumberedStart, SendsNoLineBeforeTheNumberingWasRun) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  streamer.receive("start\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), "M115\nM115\n");
  streamer.receive(kMarlin, 0.2);
  EXPECT_EQ(streamer.takeOutput(), "N0 M110 N0*125\nN2 M105*37\n");
  streamer.receive("Resend: 1\nok\n", 0.3);
  for (double now = 0.4; now < 1.5; now += 0.1) streamer.elapse(now);
  EXPECT_EQ(streamer.takeOutput(), "") << "a busy board has run neither the question nor M110";
  streamer.receive("ok\n", 1.6);
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.receive("ok\n", 1.7);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
}

TEST_F(NumberedStart, TakesNoLateOkForThatOfALine) {
  StreamSettings lossy = settings();
  lossy.link = LinkKind::Lossy;
  lossy.temperature_interval_s = 1;
  Streamer streamer(program_, lossy);
  streamer.start(0.0);
  streamer.elapse(5.0);  // the question is put again
  streamer.takeOutput();
  streamer.receive(kMarlin, 5.1);
  EXPECT_EQ(streamer.takeOutput(), "N0 M110 N0*125\nN2 M105*37\n");
  streamer.receive("Resend: 1\nok\n", 5.2);  // a wrong number is refused before what is queued is done
  EXPECT_EQ(streamer.takeOutput(), "") << "two oks are still due";
  streamer.receive("ok\n", 5.21);
  EXPECT_EQ(streamer.takeOutput(), "");
  streamer.receive("ok\n", 5.22);
  EXPECT_EQ(streamer.takeOutput(), "M155 S1\n");
  streamer.receive("ok\n", 5.23);
  EXPECT_EQ(streamer.takeOutput(), line(1));
  streamer.receive("ok\n", 5.24);
  EXPECT_EQ(streamer.takeOutput(), line(2));
  EXPECT_EQ(streamer.status().lines_acknowledged, 1U);
}

TEST_F(NumberedStart, GoesOnWithoutAnOkThatWasLost) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  streamer.receive(kMarlin, 0.0);
  streamer.takeOutput();
  streamer.receive("Resend: 1\nok\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), "") << "the ok to M110 is due";
  EXPECT_NEAR(streamer.nextDeadline(), 2.6, 1e-9);
  for (int i = 0; i < 2; ++i) streamer.elapse(2.601);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
}

/// The board has read all, and runs what another user has left in its queue.
TEST_F(NumberedStart, WaitsAsLongAsTheMachineRunsACommand) {
  for (const std::string sign : {"echo:busy: processing\n", " T:80.0 /200.0 B:20.0 /0.0 @:127 W:?\n"}) {
    Streamer streamer(program_, settings());
    streamer.start(0.0);
    streamer.receive("start\n", 0.1);
    streamer.receive(std::string(kMarlin) + "Resend: 1\nok\n", 0.2);
    streamer.takeOutput();
    for (double now = 2.0; now < 60.0; now += 2.0) {
      streamer.receive(sign, now);
      for (const double later : {0.1, 0.8, 1.9}) streamer.elapse(now + later);
      EXPECT_EQ(streamer.takeOutput(), "") << sign << now;
    }
    streamer.receive("ok\nok\n", 60.0);
    EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4)) << sign;
  }
}

/// A machine that was told so by the job before reports its temperatures while it is idle.
TEST_F(NumberedStart, IsNotHeldUpByReportsOfTemperatures) {
  Streamer streamer(program_, settings());
  streamer.start(0.0);
  streamer.receive(std::string(kMarlin) + "Resend: 1\nok\n", 0.1);
  streamer.takeOutput();
  for (const double now : {1.0, 2.0, 2.59}) {
    streamer.receive(" T:20.0 /0.0 B:20.0 /0.0 @:0\n", now);
    EXPECT_EQ(streamer.takeOutput(), "") << now;
  }
  for (const double now : {2.65, 2.66}) streamer.elapse(now);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
}

TEST_F(NumberedStart, GoesOnWithoutALostOkHoweverSoonAMachineMustAnswer) {
  StreamSettings hasty = settings();
  hasty.connect_timeout_s = 1.0;
  Streamer streamer(program_, hasty);
  streamer.start(0.0);
  streamer.receive(std::string(kMarlin) + "Resend: 1\nok\n", 0.1);
  streamer.takeOutput();
  streamer.elapse(1.5);
  EXPECT_EQ(streamer.status().state, PackmlState::Starting);
  EXPECT_NEAR(streamer.nextDeadline(), 2.6, 1e-9);
  for (const double now : {2.601, 2.602}) streamer.elapse(now);
  EXPECT_EQ(streamer.takeOutput(), line(1) + line(2) + line(3) + line(4));
}

}  // namespace
}  // namespace lamina
