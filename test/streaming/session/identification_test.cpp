// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "support/scoped_entry.hpp"

namespace lamina {
namespace {

StreamableProgram anyProgram() { return StreamableProgram::fromText("one line", "G1 X1\n"); }

/// A streamer that asks who is there.
struct Asking {
  Asking() : streamer(anyProgram(), {}) {
    streamer.start(0.0);
    question = streamer.takeOutput();
  }

  Streamer streamer;
  std::string question;
};

TEST(Identification, AsksForTheNameBeforeAnythingElse) { EXPECT_EQ(Asking().question, "M115\n"); }

TEST(Identification, TakesFirmwareOfAnyOtherNameForMarlin) {
  for (const char* answer : {"FIRMWARE_NAME:Marlin 2.1.3 SOURCE_CODE_URL:github.com\nok\n",
                             "FIRMWARE_NAME:Prusa-Firmware 3.14 based on Marlin\nok\n", "ok\n"}) {
    Asking asking;
    asking.streamer.receive(answer, 0.1);
    EXPECT_EQ(asking.streamer.takeOutput(), frameLine(0, "M110 N0") + frameLine(2, "M105")) << answer;
    EXPECT_EQ(asking.streamer.takeStateChanges(), std::vector<PackmlState>{PackmlState::Starting});
  }
}

TEST(Identification, PassesOnWhatComesBehindTheAnswer) {
  Asking asking;
  asking.streamer.receive("FIRMWARE_NAME:Marlin\nok\nok\nResend: 1\nok\n", 0.1);
  EXPECT_NE(asking.streamer.takeOutput().find("M155 S1\n"), std::string::npos)
      << "the request for line 1 confirms the numbering";
}

TEST(Identification, RefusesAMachineThatAsksForAPassword) {
  Asking asking;
  asking.streamer.receive("RepRapFirmware Telnet interface\r\n\r\nPlease enter your password:\r\n> ", 0.1);
  EXPECT_EQ(asking.streamer.status().failure.code, ErrorCode::Rejected);
  EXPECT_NE(asking.streamer.status().failure.message.find("password"), std::string::npos);
  EXPECT_EQ(asking.streamer.takeOutput(), "");
}

TEST(Identification, GivesTheNameInTheStatus) {
  Asking asking;
  asking.streamer.receive("FIRMWARE_NAME:Marlin 2.1.3 SOURCE_CODE_URL:x\nok\n", 0.1);
  EXPECT_EQ(asking.streamer.status().firmware_name, "Marlin 2.1.3");
  EXPECT_EQ(asking.streamer.status().lines_total, 1U);
}

TEST(Identification, AsksAgainOfAMachineThatBoots) {
  Asking asking;
  asking.streamer.receive(
      "\xff"
      "start\n",
      1.0);
  EXPECT_EQ(asking.streamer.takeOutput(), "M115\n");
  asking.streamer.elapse(10.5);
  EXPECT_EQ(asking.streamer.status().state, PackmlState::Starting) << "the time counts from the greeting";
}

TEST(Identification, WaitsForAMachineThatIsBusyWithSomethingElse) {
  Asking asking;
  for (double now = 1.0; now < 60.0; now += 1.0) {
    asking.streamer.receive("echo:busy: processing\n", now);
    asking.streamer.elapse(now);
  }
  EXPECT_EQ(asking.streamer.status().state, PackmlState::Starting);
}

TEST(Identification, EndsWithoutAWordToAMachineThatDoesNotAnswer) {
  Asking asking;
  asking.streamer.elapse(10.0);
  EXPECT_EQ(asking.streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(asking.streamer.status().failure.code, ErrorCode::TimedOut);
  EXPECT_EQ(asking.streamer.takeOutput(), "");
}

TEST(Identification, IsLeftByDisconnectionAndAbortAtOnce) {
  Asking unplugged;
  unplugged.streamer.disconnect("lost the link", 0.1);
  EXPECT_EQ(unplugged.streamer.status().failure.code, ErrorCode::Disconnected);
  Asking aborted;
  aborted.streamer.abort({ErrorCode::Cancelled, "stopped"}, 0.1);
  EXPECT_EQ(aborted.streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(aborted.streamer.takeOutput(), "");
}

/// Speaks to firmware of one name.
class Named : public MarlinFirmware {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override { return firmware_name == "Ours"; }
};

TEST(Identification, PrefersAProtocolThatKnowsTheNameToMarlin) {
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> one(firmwareProtocols(), "ours",
                                                                       std::make_shared<Named>());
  Asking asking;
  asking.streamer.receive("FIRMWARE_NAME:Ours\nok\n", 0.1);
  EXPECT_EQ(asking.streamer.takeOutput(), frameLine(0, "M110 N0") + frameLine(2, "M105"));
}

TEST(Identification, LeavesTheChoiceAmongSeveralToTheUser) {
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> one(firmwareProtocols(), "ours",
                                                                       std::make_shared<Named>());
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> two(firmwareProtocols(), "theirs",
                                                                       std::make_shared<Named>());
  Asking asking;
  asking.streamer.receive("FIRMWARE_NAME:Ours\nok\n", 0.1);
  EXPECT_EQ(
      asking.streamer.status().failure.message,
      "the machine's firmware is \"Ours\", which speaks ours, theirs; expected stream.firmware to be one "
      "of these");
}

}  // namespace
}  // namespace lamina
