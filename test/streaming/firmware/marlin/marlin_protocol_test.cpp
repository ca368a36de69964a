// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(MarlinProtocol, FramesTheLinesOfTheReprapDocumentation) {
  // Example of https://reprap.org/wiki/G-code, "Checking".
  EXPECT_EQ(frameLine(3, "T0"), "N3 T0*57\n");
  EXPECT_EQ(frameLine(4, "G92 E0"), "N4 G92 E0*67\n");
  EXPECT_EQ(frameLine(5, "G28"), "N5 G28*22\n");
  EXPECT_EQ(frameLine(6, "G1 F1500.0"), "N6 G1 F1500.0*82\n");
  EXPECT_EQ(frameLine(7, "G1 X2.0 Y2.0 F3000.0"), "N7 G1 X2.0 Y2.0 F3000.0*85\n");
  EXPECT_EQ(frameLine(8, "G1 X3.0 Y3.0"), "N8 G1 X3.0 Y3.0*33\n");
}

TEST(MarlinProtocol, ReadsPlainAndAdvancedOks) {
  EXPECT_EQ(parseReply("ok").kind, ReplyKind::Ok);
  EXPECT_EQ(parseReply("ok\r").kind, ReplyKind::Ok);
  EXPECT_FALSE(parseReply("ok").line);
  const FirmwareReply advanced = parseReply("ok N12 P15 B3");
  EXPECT_EQ(advanced.kind, ReplyKind::Ok);
  EXPECT_EQ(advanced.line, 12U);
  EXPECT_EQ(advanced.free_planner_blocks, 15);
  EXPECT_EQ(advanced.free_command_slots, 3);
  EXPECT_EQ(parseReply("okay").kind, ReplyKind::Information);
}

TEST(MarlinProtocol, ReadsRequestsToResend) {
  EXPECT_EQ(parseReply("Resend: 17").line, 17U);
  EXPECT_EQ(parseReply("Resend:17").line, 17U);
  EXPECT_EQ(parseReply("rs 17").line, 17U);
  EXPECT_EQ(parseReply("rs N17").line, 17U);
  EXPECT_EQ(parseReply("Resend: nonsense").kind, ReplyKind::Resend);
  EXPECT_FALSE(parseReply("Resend: nonsense").line);
}

TEST(MarlinProtocol, ReportsLineErrorsFromHaltsFromWarnings) {
  EXPECT_EQ(parseReply("Error:checksum mismatch, Last Line: 4").kind, ReplyKind::LineError);
  EXPECT_EQ(parseReply("Error:Line Number is not Last Number+1, Last Line: 4").kind, ReplyKind::LineError);
  EXPECT_EQ(parseReply("Error:Printer halted. kill() called!").kind, ReplyKind::Fatal);
  EXPECT_EQ(parseReply("Error:Thermal Runaway, system stopped! Heater_ID: 0").kind, ReplyKind::Fatal);
  EXPECT_EQ(parseReply("Error:MINTEMP triggered, system stopped!").kind, ReplyKind::Fatal);
  EXPECT_EQ(parseReply("!! limit switch").kind, ReplyKind::Fatal);
  EXPECT_EQ(parseReply("Error:SD card is full").kind, ReplyKind::Warning);
}

TEST(MarlinProtocol, ReadsSignsOfLife) {
  EXPECT_EQ(parseReply("echo:busy: processing").kind, ReplyKind::Busy);
  EXPECT_EQ(parseReply("busy: heating").kind, ReplyKind::Busy);
  EXPECT_EQ(parseReply("start").kind, ReplyKind::Start);
  EXPECT_EQ(parseReply("echo:SD card ok").kind, ReplyKind::Information);
  EXPECT_EQ(parseReply("").kind, ReplyKind::Information);
}

TEST(MarlinProtocol, ReadsTemperatures) {
  const FirmwareReply answer = parseReply("ok T:201.2 /210.0 B:59.9 /60.0 T0:201.2 /210.0 @:127 B@:0");
  ASSERT_TRUE(answer.temperatures);
  EXPECT_EQ(answer.kind, ReplyKind::Ok);
  EXPECT_DOUBLE_EQ(answer.temperatures->nozzle_c, 201.2);
  EXPECT_DOUBLE_EQ(answer.temperatures->nozzle_target_c.value(), 210.0);
  EXPECT_DOUBLE_EQ(answer.temperatures->bed_c.value(), 59.9);
  EXPECT_DOUBLE_EQ(answer.temperatures->bed_target_c.value(), 60.0);
  const FirmwareReply waiting = parseReply(" T:50.0 E:0 W:?");
  ASSERT_TRUE(waiting.temperatures);
  EXPECT_FALSE(waiting.temperatures->bed_c);
}

TEST(MarlinProtocol, ReadsPositions) {
  const FirmwareReply report = parseReply("X:1.50 Y:-2.25 Z:0.30 E:12.5 Count X:120 Y:-180 Z:120");
  ASSERT_TRUE(report.position);
  EXPECT_DOUBLE_EQ(report.position->x, 1.5);
  EXPECT_DOUBLE_EQ(report.position->y, -2.25);
  EXPECT_DOUBLE_EQ(report.position->z, 0.3);
  EXPECT_DOUBLE_EQ(report.position->e, 12.5);
  EXPECT_FALSE(parseReply("X:1.50 Y:nonsense Z:0.3").position);
}

TEST(MarlinProtocol, KnowsAGreetingBehindStrayBytesAndOfOtherFirmware) {
  for (const std::string greeting : {"start", "\xffstart", "\x01\x7f\xfestart", "Grbl 1.1h ['$' for help]",
                                     "RepRapFirmware for Duet 3 MB6HC v3.5.1 (2024-04-19) is up and running.",
                                     " External Reset", "echo: Free Memory: 3712  PlannerBufferBytes: 1408"})
    EXPECT_EQ(parseReply(greeting).kind, ReplyKind::Start) << greeting;
  for (const std::string other :
       {"restart", "echo:restart", "starting", "echo: a long line that ends in start"})
    EXPECT_NE(parseReply(other).kind, ReplyKind::Start) << other;
}

TEST(MarlinProtocol, ReadsTheActionsAMachineAsksOfItsHost) {
  EXPECT_EQ(parseReply("//action:pause").kind, ReplyKind::Pause);
  EXPECT_EQ(parseReply("// action:paused").kind, ReplyKind::Pause);
  EXPECT_EQ(parseReply("//action:out_of_filament T0").kind, ReplyKind::Pause);
  EXPECT_EQ(parseReply("//action:resumed").kind, ReplyKind::Resume);
  EXPECT_EQ(parseReply("//action:cancel").kind, ReplyKind::Cancel);
  EXPECT_EQ(parseReply("//action:poweroff").kind, ReplyKind::Cancel);
  EXPECT_EQ(parseReply("//action:prompt_begin Nozzle clogged?").kind, ReplyKind::Information);
  EXPECT_EQ(parseReply("// Klipper state: Ready").kind, ReplyKind::Information);
}

TEST(MarlinProtocol, TellsCommandsThatWereNotDoneFromOthers) {
  EXPECT_EQ(parseReply("echo:Unknown command: \"G5\"").kind, ReplyKind::NotDone);
  EXPECT_EQ(parseReply("Unknown M code: M290 Z-0.05").kind, ReplyKind::NotDone) << "Prusa's firmware";
  EXPECT_EQ(parseReply("Unknown G code: G5").kind, ReplyKind::NotDone);
  EXPECT_EQ(parseReply("echo: cold extrusion prevented").kind, ReplyKind::NotDone);
  EXPECT_EQ(parseReply("echo:SD card ok").kind, ReplyKind::Information);
  EXPECT_EQ(parseReply("Re\023end: 12").kind, ReplyKind::Unreadable);
  EXPECT_EQ(parseReply("fatal: heater 1 disconnected").kind, ReplyKind::Fatal);
}

TEST(MarlinProtocol, ReadsTheNameOfTheFirmware) {
  EXPECT_EQ(
      parseReply("FIRMWARE_NAME:Marlin 2.1.2 (Nov 22 2026) SOURCE_CODE_URL:github.com PROTOCOL_VERSION:1.0")
          .firmware_name,
      "Marlin 2.1.2 (Nov 22 2026)");
  EXPECT_EQ(parseReply(
                "FIRMWARE_NAME: RepRapFirmware for Duet 2 WiFi/Ethernet FIRMWARE_VERSION: 3.4.5 ELECTRONICS: "
                "Duet WiFi")
                .firmware_name,
            "RepRapFirmware for Duet 2 WiFi/Ethernet");
  EXPECT_EQ(parseReply("FIRMWARE_VERSION:v0.12.0 FIRMWARE_NAME:Klipper").firmware_name, "Klipper");
  EXPECT_EQ(parseReply("ok").firmware_name, "");
}

}  // namespace
}  // namespace lamina
