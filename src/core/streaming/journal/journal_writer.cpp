// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/journal/journal_writer.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kLeastAhead = 256;  // lines
constexpr std::uint64_t kUncertainOks = 8;  // an ok does not say what it is for, and noise may make one
constexpr double kAheadTime = 0.2;          // s
constexpr double kMeasuringTime = 0.02;     // s: the faster the rate is known, the fewer waits at the start
constexpr double kAcknowledgementInterval = 0.1;  // s

}  // namespace

JournalWriter::JournalWriter(Write write, const JobProgress& known, std::uint64_t lines_total,
                             double patience_s)
    : lines_total_(lines_total),
      taken_before_(known.taken_through),
      ahead_(kLeastAhead),
      measured_from_(known.taken_through),
      asked_(known),
      keeper_(std::move(write), patience_s) {}

/// How many lines leave in the time that the file is ahead.
void JournalWriter::measureRate(std::uint64_t sent, double now) {
  const double passed = now - measured_since_;
  if (measured_since_ >= 0.0 && passed < kMeasuringTime) return;
  if (measured_since_ >= 0.0) {
    const double lines = static_cast<double>(sent - std::min(sent, measured_from_));
    ahead_ = std::max(kLeastAhead, static_cast<std::uint64_t>(lines * kAheadTime / passed));
  }
  measured_since_ = now;
  measured_from_ = sent;
}

void JournalWriter::record(const StreamStatus& status, double now) {
  if (has_failed_) return;
  measureRate(status.lines_sent, now);
  JobProgress progress = asked_;
  // Announced anew when half of what was announced has left.
  if (status.lines_sent + ahead_ / 2 > progress.sent_through)
    progress.sent_through =
        std::max(progress.sent_through, std::min(lines_total_, status.lines_sent + ahead_));
  const std::uint64_t uncertain = status.state == PackmlState::Complete ? 0 : kUncertainOks;
  const std::uint64_t acknowledged = std::min(status.lines_acknowledged, progress.sent_through);
  progress.taken_through = std::max(taken_before_, acknowledged - std::min(acknowledged, uncertain));
  progress.layer = status.layer;
  progress.state = status.state;
  const bool is_due = progress.taken_through != asked_.taken_through && now >= next_acknowledgement_;
  if (!std::exchange(has_asked_, true) || is_due || progress.sent_through != asked_.sent_through ||
      progress.layer != asked_.layer || progress.state != asked_.state) {
    next_acknowledgement_ = now + kAcknowledgementInterval;
    asked_ = progress;
    keeper_.keep(progress, now);
  }
  require(status.lines_sent);
}

void JournalWriter::require(std::uint64_t sent) {
  try {
    keeper_.await([sent](const JobProgress& written) { return written.sent_through >= sent; });
  } catch (const FileError&) {
    has_failed_ = true;
    throw;
  }
}

}  // namespace lamina
