// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/streaming/silent_machine.hpp"

#include <cmath>

namespace lamina::test {
namespace {

constexpr int kMostDeadlines = 100000;

void note(Streamer& streamer, double now_s, SilentJob& job) {
  for (const PackmlState state : streamer.takeStateChanges()) {
    job.entered_s.emplace(state, now_s);
    job.trace += std::to_string(now_s) + " " + toString(state) + "\n";
  }
  const std::string sent = streamer.takeOutput();
  if (!sent.empty()) job.trace += std::to_string(now_s) + " > " + sent + "\n";
}

}  // namespace

SilentJob streamedTo(Silence silence, const StreamSettings& settings, const std::string& program) {
  const auto lines = StreamableProgram::fromText("job", program, settings);
  Streamer streamer(lines, settings);
  SilentJob job;
  streamer.start(0.0);
  note(streamer, 0.0, job);
  double now_s = 0.0;
  if (silence != Silence::FromTheStart) {
    streamer.receive(kBeginAnswered, now_s);
    note(streamer, now_s, job);
  }
  if (silence == Silence::FromTheAbort) {
    now_s = 1.0;
    streamer.abort({ErrorCode::Cancelled, "enough"}, now_s);
    note(streamer, now_s, job);
  }
  for (int i = 0; i < kMostDeadlines && !isFinal(streamer.status().state); ++i) {
    now_s = streamer.nextDeadline();
    if (!std::isfinite(now_s)) break;
    streamer.elapse(now_s);
    note(streamer, now_s, job);
  }
  return job;
}

}  // namespace lamina::test
