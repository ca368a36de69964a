// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "lamina/streaming/session/streamer.hpp"

namespace lamina::test {

/// When a machine that is streamed to falls silent.
enum class Silence {
  FromTheStart,  ///< it never answers
  OnceBegun,     ///< it answers what begins the job, and no line of it
  FromTheAbort,  ///< the same, and the job is aborted 1 s later
};

/// What Marlin answers until the first line of a job is sent, without reports.
inline constexpr char kBeginAnswered[] =
    "FIRMWARE_NAME:Marlin\nok\nok\nError:Line Number is not Last Number+1, Last Line: 0\nResend: 1\nok\n";

/// Ten short moves; the last line is 40 bytes long.
inline constexpr char kTenMoves[] =
    "G1 X1\nG1 X2\nG1 X3\nG1 X4\nG1 X5\nG1 X6\nG1 X7\nG1 X8\nG1 X9\nG1 X10.00000 Y10.00000 Z10.00000 "
    "E10.0000\n";

/// A job on such a machine, until it is over.
struct SilentJob {
  std::string trace;                        ///< what is sent when, and the states entered when
  std::map<PackmlState, double> entered_s;  ///< the first time
};

SilentJob streamedTo(Silence silence, const StreamSettings& settings, const std::string& program);

inline std::string traceOf(const StreamSettings& settings, const std::string& program, Silence silence) {
  return streamedTo(silence, settings, program).trace;
}

}  // namespace lamina::test
