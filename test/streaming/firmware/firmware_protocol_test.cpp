// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/firmware_protocol.hpp"

#include <gtest/gtest.h>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "support/scoped_entry.hpp"

namespace lamina {
namespace {

/// A firmware that counts lines in brackets and says "done" for ok.
class BracketFirmware : public MarlinFirmware {
 public:
  std::string framed(std::uint64_t number, std::string_view command) const override {
    return "[" + std::to_string(number) + "] " + std::string(command) + "\n";
  }
  FirmwareReply read(std::string_view line) const override {
    return MarlinFirmware::read(line == "done" ? "ok" : line);
  }
  std::string identification() const override { return "WHO?"; }
  bool isSpokenBy(std::string_view firmware_name) const override { return firmware_name == "Brackets"; }
  std::string numberedFrom(std::uint64_t number) const override { return "COUNT " + std::to_string(number); }
  std::string harmless() const override { return "HEAT?"; }
  std::string endOfMotions() const override { return "REST"; }
  std::vector<std::string> stop() const override { return {"HALT"}; }
  std::vector<std::string> heatersOff() const override { return {"COLD"}; }
};

StreamSettings bracketSettings() {
  StreamSettings settings;
  settings.firmware = "brackets";
  settings.temperature_interval_s = 0;
  return settings;
}

TEST(FirmwareProtocol, ThatWasAddedIsSpokenToAProgramsEnd) {
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> entry(firmwareProtocols(), "brackets",
                                                                         std::make_shared<BracketFirmware>());
  Streamer streamer(StreamableProgram::fromText("one line", "G1 X1\n"), bracketSettings());
  streamer.start(0.0);
  EXPECT_EQ(streamer.takeOutput(), "WHO?\n");
  streamer.receive("FIRMWARE_NAME:Brackets\ndone\n", 0.05);
  EXPECT_EQ(streamer.takeOutput(), "[0] COUNT 0\n[2] HEAT?\n");
  streamer.receive("done\nResend: 1\ndone\n", 0.1);
  EXPECT_EQ(streamer.takeOutput(), "[1] G1 X1\n");
  streamer.receive("done\n", 0.2);
  EXPECT_EQ(streamer.takeOutput(), "[3] HEAT?\n");
  streamer.receive("Resend: 2\ndone\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "REST\n");
  streamer.receive("done\n", 0.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Complete);
}

TEST(FirmwareProtocol, ThatWasAddedStopsSafely) {
  const test::ScopedEntry<std::shared_ptr<const FirmwareProtocol>> entry(firmwareProtocols(), "brackets",
                                                                         std::make_shared<BracketFirmware>());
  Streamer streamer(StreamableProgram::fromText("one line", "G1 X1\n"), bracketSettings());
  streamer.start(0.0);
  streamer.receive("FIRMWARE_NAME:Brackets\ndone\n", 0.05);
  streamer.receive("done\nResend: 1\ndone\n", 0.1);
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "stopped"}, 0.2);
  EXPECT_EQ(streamer.takeOutput(), "M108\nHALT\nCOLD\n[1002] COUNT 1002\n[1004] HEAT?\n");
}

TEST(FirmwareProtocol, OfAnUnknownNameIsRefusedNamingThoseThereAre) {
  StreamSettings settings;
  settings.firmware = "smoke signals";
  try {
    static_cast<void>(Streamer(StreamableProgram::fromText("one line", "G1 X1\n"), settings));
    FAIL() << "nothing thrown";
  } catch (const InvalidConfig& error) {
    EXPECT_STREQ(
        error.what(),
        "stream.firmware is 'smoke signals'; must be one of grbl | klipper | marlin | reprapfirmware");
  }
}

}  // namespace
}  // namespace lamina
