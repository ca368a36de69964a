// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "lamina/streaming/session/streamer.hpp"

namespace lamina::test {

inline std::string tenLines() {
  std::string text;
  for (int i = 1; i <= 10; ++i) text += "G1 X" + std::to_string(i) + "\n";
  return text;
}

inline constexpr char kMarlin[] =
    "FIRMWARE_NAME:Marlin 2.1.2 (Nov 22 2026) SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin "
    "PROTOCOL_VERSION:1.0\nCap:AUTOREPORT_TEMP:1\nok\n";

class ScriptedPeer : public testing::Test {
 protected:
  static StreamSettings settings() {
    StreamSettings settings;
    settings.temperature_interval_s = 0;
    return settings;
  }

  /// Begins a job and answers until its first lines are under way.
  /// @param more  lines of the machine's answer about itself, in front of the others
  void begin(Streamer& streamer, const std::string& more = "") {
    streamer.start(0.0);
    EXPECT_EQ(streamer.takeOutput(), "M115\n");
    streamer.receive(more + kMarlin, 0.0);
    EXPECT_EQ(streamer.takeOutput(), "N0 M110 N0*125\nN2 M105*37\n");
    streamer.receive("ok\nError:Line Number is not Last Number+1, Last Line: 0\nResend: 1\nok\n", 0.0);
    EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  }
  static std::string line(std::uint64_t number) { return frameLine(number, "G1 X" + std::to_string(number)); }

  StreamableProgram program_ = StreamableProgram::fromText("ten lines", tenLines());
};

}  // namespace lamina::test
