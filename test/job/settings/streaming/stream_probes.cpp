// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The streamer, against machines that fall silent or lack an answer, at times that are set.
#include <cmath>

#include "job/settings/setting_probe.hpp"
#include "job/settings/streaming/silent_machine.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "lamina/streaming/session/streamer.hpp"

namespace lamina::test {
namespace {

/// What is sent when, and the states entered when, of a job whose machine falls silent.
std::function<std::string(const SettingTexts& set)> silentAt(Silence silence, const std::string& program) {
  return [silence, program](const SettingTexts& set) {
    return traceOf(settingsWith<StreamSettings>(set), program, silence);
  };
}

/// When a line is sent again by firmware that says no ok after its request.
std::string sentAgainAt(const SettingTexts& set) {
  Streamer streamer(StreamableProgram::fromText("job", kTenMoves), settingsWith<StreamSettings>(set));
  streamer.start(0.0);
  streamer.receive(kBeginAnswered, 0.0);
  streamer.receive("Resend: 1\n", 0.1);
  return numbersText({streamer.nextDeadline()});
}

/// What a grbl is told that has locked itself.
std::string toldALocked(const SettingTexts& set) {
  Streamer streamer(StreamableProgram::fromText("job", "G1 X1\n"), settingsWith<StreamSettings>(set));
  streamer.start(0.0);
  streamer.elapse(0.0);
  streamer.receive("<Alarm|MPos:0.000,0.000,0.000>\n", 0.1);
  return streamer.takeOutput();
}

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

/// Why a print server is not streamed to that is not there.
std::string notStreamed(const SettingTexts& set) {
  try {
    const StreamSession session(StreamableProgram::fromText("part", "G1 X1\n"),
                                settingsWith<StreamSettings>(set), {"http://127.0.0.1:1", 0}, {});
    return "streamed";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

std::vector<SettingProbe> streamProbes() {
  return {
      {"a machine that never answers",
       "",
       silentAt(Silence::FromTheStart, kTenMoves),
       {{"stream.connect_timeout_s=4"}, {"stream.firmware=grbl"}}},
      {"a machine that falls silent",
       "stream.temperature_interval_s=0",
       silentAt(Silence::OnceBegun, kTenMoves),
       {{"stream.window_bytes=100", "stream.window_lines=20"},
        {"stream.window_lines=2"},
        {"stream.link=lossy"},
        {"stream.max_line_bytes=32"},
        {"stream.probe_after_s=4"},
        {"stream.silence_timeout_s=20"},
        {"stream.temperature_interval_s=5"},
        {"stream.position_interval_s=2"}}},
      {"a machine that falls silent while it homes",
       "stream.temperature_interval_s=0",
       silentAt(Silence::OnceBegun, "G28\nG1 X1\n"),
       {{"stream.blocking_timeout_s=600"}}},
      {"a machine that confirms no safe stop",
       "stream.temperature_interval_s=0",
       silentAt(Silence::FromTheAbort, kTenMoves),
       {{"stream.safe_stop_timeout_s=3"}, {"stream.keep_heaters_on=true"}}},
      {"a machine that says no ok after a request",
       "stream.temperature_interval_s=0",
       sentAgainAt,
       {{"stream.settle_s=0.5"}}},
      {"a print server that is not there", "", notStreamed, {{"stream.password_file=/nowhere/at/all"}}},
      {"a job whose progress is kept",
       "stream.journal=/somewhere",
       [](const SettingTexts& set) { return journalPath(settingsWith<StreamSettings>(set), "/dev/ttyUSB0"); },
       {{"stream.journal=/elsewhere"}}},
      {"a Klipper that does not hear a stop",
       "stream.firmware=klipper",
       sentToADeafKlipper,
       {{"stream.emergency_stop=unconfirmed"}}},
      {"a grbl that has locked itself", "stream.firmware=grbl", toldALocked, {{"stream.unlock=once"}}}};
}

}  // namespace lamina::test
