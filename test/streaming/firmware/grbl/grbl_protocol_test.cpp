// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(GrblProtocol, ReadsReports) {
  const GrblReply reply = parseGrblReply(
      "<Hold:1|MPos:1.500,-2.000,0.250|Bf:14,120|FS:500,8000|WCO:1.000,0.000,0.000|Ov:100,100,100>\r");
  ASSERT_EQ(reply.kind, GrblReplyKind::Report);
  EXPECT_EQ(reply.report->state, GrblState::Hold);
  EXPECT_EQ(reply.report->substate, 1);
  EXPECT_EQ(reply.report->machine_position, (GrblAxes{1.5, -2.0, 0.25}));
  EXPECT_EQ(reply.report->work_offset, (GrblAxes{1.0, 0.0, 0.0}));
  EXPECT_EQ(reply.report->free_blocks, 14);
  EXPECT_EQ(reply.report->free_bytes, 120);
  EXPECT_EQ(reply.report->spindle_speed, 8000.0);
}

TEST(GrblProtocol, ReadsCodesAndGreetings) {
  EXPECT_EQ(parseGrblReply("ok\r").kind, GrblReplyKind::Ok);
  EXPECT_EQ(parseGrblReply("okk").kind, GrblReplyKind::Other);
  EXPECT_EQ(parseGrblReply("error:20").code, 20);
  EXPECT_EQ(parseGrblReply("error:2x").kind, GrblReplyKind::Other);
  EXPECT_EQ(parseGrblReply("ALARM:3").code, 3);
  EXPECT_EQ(parseGrblReply("\xffGrbl 1.1h ['$' for help]").kind, GrblReplyKind::Greeting);
  EXPECT_EQ(parseGrblReply("GrblHAL 1.1f ['$' or '$HELP' for help]").kind, GrblReplyKind::Greeting);
  EXPECT_EQ(parseGrblReply("<Idle|MPos:1.0").kind, GrblReplyKind::Other);
}

TEST(GrblProtocol, TellsCodesInWords) {
  EXPECT_EQ(meaningOfGrblError(20, GrblDialect::FluidNc), "the firmware does not know this command");
  EXPECT_EQ(meaningOfGrblAlarm(10, GrblDialect::GrblHal), "the emergency stop is engaged");
  EXPECT_EQ(meaningOfGrblAlarm(10, GrblDialect::FluidNc), "the spindle could not be controlled");
  EXPECT_EQ(meaningOfGrblError(250, GrblDialect::Grbl), "a code that the firmware's own manual explains");
}

TEST(GrblProtocol, ChangesOverridesByStepsOfTenAndOne) {
  EXPECT_EQ(grblFeedOverride(100, 122), "\x91\x91\x93\x93");
  EXPECT_EQ(grblFeedOverride(100, 89), "\x92\x94");
  EXPECT_EQ(grblFeedOverride(195, 400), "\x93\x93\x93\x93\x93");
  EXPECT_EQ(grblSpindleOverride(100, 100), "");
  EXPECT_EQ(grblSpindleOverride(100, 110), "\x9A");
  EXPECT_EQ(grblRapidOverride(30), "\x96");
}

}  // namespace
}  // namespace lamina
