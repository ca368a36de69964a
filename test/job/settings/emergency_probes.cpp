// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/setting_probe.hpp"
#include "lamina/streaming/client/streamer.hpp"

namespace lamina::test {
namespace {

/// What a Klipper is sent that does not hear a stop, at its port.
std::string sentToADeafKlipper(const SettingTexts& set) {
  const auto settings = settingsWith<StreamSettings>(set);
  Streamer streamer(StreamableProgram::fromText("job", "M109 S200\n", settings), settings);
  streamer.start(0.0);
  streamer.receive("ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:v0.12\n", 0.1);
  streamer.receive("// Klipper state: Ready\nok\n", 0.2);
  streamer.receive("// ECHO LAMINA=1\nok\n", 0.3);
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  for (double now = 2.0; now < 15.0; now += 1.0) streamer.elapse(now);
  return streamer.takeOutput();
}

}  // namespace

std::vector<SettingProbe> emergencyProbes() {
  return {{"a Klipper that does not hear a stop",
           "stream.firmware=klipper",
           sentToADeafKlipper,
           {{"stream.emergency_stop=unconfirmed"}}}};
}

}  // namespace lamina::test
