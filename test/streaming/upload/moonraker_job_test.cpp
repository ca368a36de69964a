// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What Klipper does behind Moonraker as no Duet does, seen with the real ones
// (docs/streaming/firmware/upload.md).

#include <gtest/gtest.h>

#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

using test::orderOf;
using test::SimulatedHttp;

bool says(const SimulatedHttp& link, const std::string& part) {
  return link.job.status().failure.message.find(part) != std::string::npos;
}

TEST(MoonrakerJob, WaitsUntilAnothersCommandHasEnded) {
  SimulatedHttp link(orderOf("G1 X1\n"), {}, makeEmulatedMoonraker());
  link.server->printer.moveFor(5.0);
  link.start();
  link.runUntil(4.9);
  EXPECT_TRUE(link.server->printer.files.empty());
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
}

TEST(MoonrakerJob, StartsNothingBehindAnothersCommand) {
  SimulatedHttp link(orderOf("G1 X1\n"), {}, makeEmulatedMoonraker());
  link.server->printer.moveFor(100.0);
  link.server->printer.nozzle_target_c = 250.0;
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected);
  EXPECT_TRUE(says(link, "has been busy for 10 s")) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.nozzle_target_c, 250.0);
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST(MoonrakerJob, FollowsAPrintThroughARestartOfTheServer) {
  const std::string text = test::hotProgram(500);
  SimulatedHttp link(orderOf(text), {}, makeEmulatedMoonraker());
  link.events.push_back({2.5, [](EmulatedPrintServer& server) { server.has_just_started = true; }});
  link.events.push_back({9.5, [](EmulatedPrintServer& server) { server.has_just_started = false; }});
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.executed(), test::commandsOf(text));
}

TEST(MoonrakerJob, SaysThatAServerHasNotFoundItsPrinter) {
  SimulatedHttp link(orderOf("G1 X1\n"), {}, makeEmulatedMoonraker());
  link.server->has_just_started = true;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_TRUE(says(link, "Moonraker has not found Klipper yet")) << link.job.status().failure.message;
}

TEST(MoonrakerJob, TellsAnErrorInOneLineAndHowFarItCame) {
  SimulatedHttp link(orderOf(test::hotProgram(500)), {}, makeEmulatedMoonraker());
  link.events.push_back({3.5, [](EmulatedPrintServer& server) { server.printer.breakDown(); }});
  link.run();
  const std::size_t run = link.server->printer.executed().size();
  EXPECT_TRUE(says(link, "Move out of range: 400.000 0.000 0.000")) << link.job.status().failure.message;
  EXPECT_EQ(link.job.status().lines_acknowledged, run);
}

TEST(MoonrakerJob, RefusesToLeaveOutPartsWhereKlipperCannot) {
  SimulatedHttp link(orderOf("EXCLUDE_OBJECT_DEFINE NAME=left\n" + test::hotProgram(500)), {},
                     makeEmulatedMoonraker());
  link.server->printer.excludes_parts = false;
  link.start();
  link.runUntilState(PackmlState::Execute);
  EXPECT_EQ(link.job.change({LiveSetting::CancelPart, 0.0}, link.now),
            "this Klipper leaves out no parts: its configuration has no [exclude_object]");
}

TEST(MoonrakerJob, ReportsNoBedWhereThereIsNone) {
  SimulatedHttp link(orderOf("G1 X1\n"), {}, makeEmulatedMoonraker());
  link.server->printer.has_bed = false;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  ASSERT_TRUE(link.job.status().temperatures);
  EXPECT_FALSE(link.job.status().temperatures->bed_c);
}

/// Klipper's own order: a print is complete when its last line was read, and its motions are still to come.
class MoonrakerMotionTest : public testing::Test {
 protected:
  explicit MoonrakerMotionTest(const StreamSettings& settings = {})
      : link(orderOf("M104 S200\nG1 X1\n"), settings, makeEmulatedMoonraker()) {
    link.server->printer.queue_s = 30.0;
    link.start();
    link.runUntilState(PackmlState::Completing);
  }
  void abortAt(double time_s) {
    link.runUntil(time_s);
    link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
    link.runUntil(1e5);
  }

  SimulatedHttp link;
};

TEST_F(MoonrakerMotionTest, CompleteIsToldWhenMotionsHaveEnded) {
  link.runUntil(29.0);
  EXPECT_EQ(link.job.status().state, PackmlState::Completing);
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_GE(link.now, 30.0);
}

TEST_F(MoonrakerMotionTest, AShutdownInTheLastMotionIsNotComplete) {
  link.runUntil(10.0);
  link.server->printer.halt();
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::DeviceError);
  EXPECT_TRUE(says(link, "Lost communication")) << link.job.status().failure.message;
  EXPECT_LT(link.now, 12.0);
}

TEST_F(MoonrakerMotionTest, AStopIsConfirmedOnceMotionsHaveEnded) {
  abortAt(25.0);
  const std::string& message = link.job.status().failure.message;
  EXPECT_TRUE(says(link, "its heaters are off")) << message;
  EXPECT_FALSE(says(link, "still moving")) << message;
  EXPECT_EQ(link.server->printer.nozzle_target_c, 0.0);
  EXPECT_GE(link.now, 30.0);
}

TEST_F(MoonrakerMotionTest, AStopSaysThatMotionsGoOn) {
  abortAt(5.0);
  const std::string& message = link.job.status().failure.message;
  EXPECT_TRUE(says(link, "its heaters are off; it was still moving 8 s later")) << message;
  EXPECT_LT(link.now, 15.5);
  EXPECT_TRUE(link.server->printer.files.empty());
}

StreamSettings shortPatience() {
  StreamSettings settings;
  settings.blocking_timeout_s = 12.0;
  return settings;
}

class ImpatientMotionTest : public MoonrakerMotionTest {
 protected:
  ImpatientMotionTest() : MoonrakerMotionTest(shortPatience()) {}
};

TEST_F(ImpatientMotionTest, MotionsWithoutEndAreNotComplete) {
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::TimedOut);
  EXPECT_TRUE(says(link, "was still moving 12 s later")) << link.job.status().failure.message;
}

}  // namespace
}  // namespace lamina
