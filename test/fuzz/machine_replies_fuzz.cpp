// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "lamina/streaming/session/streamer.hpp"

namespace {

/// Whoever speaks at the other end, a job's counts agree, and it ends once.
void check(const lamina::Streamer& streamer, bool was_final) {
  const lamina::StreamStatus& status = streamer.status();
  if (status.lines_acknowledged > status.lines_sent || status.lines_sent > status.lines_total) std::abort();
  if (status.state == lamina::PackmlState::Complete && status.lines_acknowledged != status.lines_total)
    std::abort();
  if (was_final && !isFinal(status.state)) std::abort();
}

/// Lets the time go on to what is waited for next.
double elapsed(lamina::Streamer& streamer, double now, double most_s) {
  const double next = std::clamp(streamer.nextDeadline(), now, now + most_s);
  streamer.elapse(next);
  return next;
}

}  // namespace

/// Any bytes are a machine's answers: the first chooses who is expected, a zero lets time go by.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 5> kFirmware = {"auto", "marlin", "grbl", "klipper", "reprapfirmware"};
  lamina::StreamSettings settings;
  settings.firmware = kFirmware[bytes[0] % kFirmware.size()];
  settings.link = (bytes[0] & 0x80U) != 0 ? lamina::LinkKind::Reliable : lamina::LinkKind::Lossy;
  settings.journal.clear();
  static const auto program =
      lamina::StreamableProgram::fromText("part", "G21\nG90\nG1 X1 F600\nG1 X2\nG4 P1\nG1 X3\nG1 X4\n");
  std::unique_ptr<lamina::Streamer> streamer;
  try {
    streamer = std::make_unique<lamina::Streamer>(program, settings);
    streamer->start(0.0);
  } catch (const lamina::InvalidConfig&) {
    return 0;  // of this firmware, on such a link
  }
  double now = 0.0;
  std::string_view rest(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  while (!rest.empty()) {
    const std::size_t piece = rest.find('\0');
    const bool was_final = isFinal(streamer->status().state);
    streamer->receive(rest.substr(0, piece), now);
    check(*streamer, was_final);
    streamer->takeOutput();
    now = elapsed(*streamer, now, 1.0);
    check(*streamer, was_final);
    rest.remove_prefix(piece == std::string_view::npos ? rest.size() : piece + 1);
  }
  // A machine that is silent from here on ends every job.
  for (int i = 0; i < 10000 && !isFinal(streamer->status().state); ++i) {
    streamer->takeOutput();
    now = elapsed(*streamer, now, 60.0);
  }
  if (!isFinal(streamer->status().state)) std::abort();
  check(*streamer, true);
  return 0;
}
