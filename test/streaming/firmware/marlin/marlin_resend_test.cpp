// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/marlin_resend.hpp"

#include <gtest/gtest.h>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {
namespace {

using Contradiction = MarlinResend::Contradiction;

StreamSettings settings() {
  StreamSettings settings;
  settings.link = LinkKind::Reliable;  // four lines
  settings.window_lines = 0;
  settings.window_bytes = 100;
  settings.settle_s = 0.5;
  return settings;
}

FirmwareReply ok() {
  FirmwareReply reply;
  reply.kind = ReplyKind::Ok;
  return reply;
}

TEST(MarlinResend, HasRoomForLinesAndBytes) {
  MarlinResend resend(settings());
  EXPECT_TRUE(resend.hasRoom(1000)) << "alone";
  resend.sent({1, 40});
  EXPECT_TRUE(resend.hasRoom(60));
  EXPECT_FALSE(resend.hasRoom(61));
  for (std::uint64_t line : {2, 3, 4}) resend.sent({line, 1});
  EXPECT_FALSE(resend.hasRoom(1));
  EXPECT_EQ(resend.acknowledge({}), 1U);
  EXPECT_TRUE(resend.hasRoom(1));
  EXPECT_EQ(resend.acknowledge({3}), 3U);
  EXPECT_EQ(resend.acknowledge({}), 4U);
  EXPECT_EQ(resend.acknowledge({}), std::nullopt);
}

TEST(MarlinResend, SendsOneLineAfterARefusalDespiteAFullWindow) {
  MarlinResend resend(settings());
  for (std::uint64_t line : {1, 2, 3, 4}) resend.sent({line, 10});
  EXPECT_FALSE(resend.takeRequest()) << "no probe was sent";
  EXPECT_EQ(resend.follow(1), "");
  resend.refuse(1, 10.0);
  EXPECT_TRUE(resend.isWaiting());
  EXPECT_EQ(resend.waitsUntil(), 10.5);
  EXPECT_TRUE(resend.hasRoom(10));
  EXPECT_TRUE(resend.absorb(1)) << "the refusal of line 2";
  EXPECT_FALSE(resend.absorb(3)) << "another line is another matter";
}

TEST(MarlinResend, WaitsUntilNothingIsDue) {
  MarlinResend resend(settings());
  resend.sent({1, 10});
  resend.takeRequest();
  resend.follow(1);
  resend.refuse(1, 0.0);
  resend.settle(0.1);
  EXPECT_TRUE(resend.isWaiting()) << "for the ok of the request";
  EXPECT_TRUE(resend.hear(ok(), 0.2));
  EXPECT_EQ(resend.waitsUntil(), 0.7);
  EXPECT_FALSE(resend.hear(ok(), 0.2)) << "of a line";
  resend.settle(0.3);
  EXPECT_FALSE(resend.isWaiting());
}

TEST(MarlinResend, WaitsForProbesNoLongerThanToTheEnd) {
  MarlinResend resend(settings());
  resend.probed();
  resend.waitForProbes(1.0);
  resend.settle(1.4);
  EXPECT_TRUE(resend.isWaiting());
  resend.settle(1.5);
  EXPECT_FALSE(resend.isWaiting());
  EXPECT_FALSE(resend.hasUnansweredProbe());
}

TEST(MarlinResend, ContradictionIsFollowedUpOnce) {
  MarlinResend resend(settings());
  resend.beginAt(5);
  EXPECT_EQ(resend.contradictionOf(5, 4), Contradiction::None);
  EXPECT_EQ(resend.contradictionOf(1, 4), Contradiction::First);
  EXPECT_EQ(resend.contradictionOf(5, 4), Contradiction::None);
  EXPECT_EQ(resend.contradictionOf(1, 4), Contradiction::First);
  EXPECT_EQ(resend.contradictionOf(1, 4), Contradiction::Repeated);
}

// A machine that is held says so each second; it is no answer that could have been lost.
TEST(MarlinResend, KnowsAResetBehindWhatAMachineSaysUnasked) {
  MarlinResend resend(settings());
  resend.beginAt(1);
  for (int i = 0; i < 30; ++i) {
    resend.hear(parseReply("wait"), 0.0);
    resend.hear(parseReply("//action:notification Layer 3"), 0.0);
  }
  EXPECT_EQ(resend.contradictionOf(2, 20), Contradiction::First);
}

TEST(MarlinResend, GivesUpALineThatIsAlwaysRefused) {
  MarlinResend resend(settings());
  for (int i = 0; i < 100; ++i) EXPECT_EQ(resend.follow(7), "") << i;
  EXPECT_EQ(resend.follow(7), "the machine refused line 7 100 times");
  EXPECT_EQ(resend.follow(8), "");
}

TEST(MarlinResend, GivesUpAfterFiveOddRequestsInARow) {
  MarlinResend resend(settings());
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(resend.isTooOdd());
  resend.acknowledge({});
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(resend.isTooOdd());
  EXPECT_TRUE(resend.isTooOdd());
}

}  // namespace
}  // namespace lamina
