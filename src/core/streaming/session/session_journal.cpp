// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/session_journal.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kFirstAhead = 256;  // lines

/// Seven digits: other senders count from 1, and an earlier job is unlikely to have been there; and a line
/// whose N is damaged into a G or M has a code that no firmware knows. Longer numbers would only slow down
/// the line.
std::uint64_t anyLineBase() {
  std::random_device source;
  return std::uniform_int_distribution<std::uint64_t>(1'000'000, 8'999'999)(source);
}

}  // namespace

SessionJournal::SessionJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                               std::shared_ptr<const ProgramRevision> revision)
    : where_(std::move(where)),
      write_([placed = where_](const JournalledJob& job) { return fileWriter(placed, job); }),
      revision_(std::move(revision)) {
  const std::optional<RevisionRecord> record = revision_ ? revision_->record() : std::nullopt;
  is_repeatable_ = !revision_ || record;
  if (!is_repeatable_ && where_.execution.empty()) where_ = {};
  job_.line_base = anyLineBase();
  if (where_.path.empty()) return;
  if (where_.unfinished) {
    is_stated_ = true;
    job_ = where_.unfinished->job;
    return;
  }
  const std::uint64_t line_base = job_.line_base;
  job_ = describedJob(program, port);
  job_.line_base = line_base;
  job_.revision = record;
  job_.execution = where_.execution;
}

std::uint64_t SessionJournal::mostLines() const {
  return job_.revision ? std::numeric_limits<std::uint64_t>::max() : job_.lines_total;
}

StreamOrder SessionJournal::placed(StreamOrder order) const {
  order.line_base = job_.line_base;
  if (!where_.unfinished) return order;
  const JobProgress& known = where_.unfinished->progress;
  order.unfinished = UnfinishedLines{known.taken_through, known.sent_through, job_.firmware_name};
  if (order.settings.firmware == kAnyFirmware) order.settings.firmware = job_.protocol;
  return order;
}

void SessionJournal::begin(const Streamer& streamer) {
  const StreamStatus& status = streamer.status();
  job_.protocol = streamer.protocol();
  job_.firmware_name = status.firmware_name;
  JobProgress known;
  known.taken_through = status.lines_acknowledged;
  known.sent_through = std::min(mostLines(), status.lines_sent + kFirstAhead);
  known.layer = status.layer;
  writer_ = std::make_unique<JournalWriter>(write_(job_), known, mostLines(), patience_s_);
}

void SessionJournal::followLink(const Streamer& streamer) {
  const PackmlState state = streamer.status().state;
  if (isFinal(state)) return;
  is_cut_off_ = streamer.isOffline();
  if (state == PackmlState::Aborting && !is_cut_off_) is_stop_sent_ = true;
}

void SessionJournal::keep(const Streamer& streamer, double now) {
  const PackmlState state = streamer.status().state;
  if (where_.path.empty() || !failure_.empty() || state == PackmlState::Idle ||
      state == PackmlState::Starting)
    return;
  try {
    // What fails before a line was sent leaves what was known of the job before.
    if (!std::exchange(has_begun_, has_begun_ || state == PackmlState::Execute)) {
      if (!has_begun_) return;
      begin(streamer);
    }
    followLink(streamer);
    StreamStatus status = stated(streamer);
    const std::string unrecorded = revision_ ? revision_->recordFailure() : std::string();
    // What is sent from now on cannot be made again: the job is none to go on with.
    if (!unrecorded.empty()) status.state = PackmlState::Aborted;
    writer_->record(status, now);
    is_stated_ = true;
    if (!unrecorded.empty()) throw FileError("the corrections are not recorded: " + unrecorded);
  } catch (const std::exception& error) {  // of a file system too: a bad disk must not end the process
    failure_ = error.what();
    failure_ += forbidsTheFirstLine() ? "; no line of execution " + where_.execution +
                                            " was sent, since nothing states that it has begun"
                                      : "; the job goes on, but could not be gone on with after a fault";
    writer_.reset();
  }
}

/// What is stated of the job. One whose lines cannot be made again is none to go on with, and has the lines
/// of its program.
StreamStatus SessionJournal::stated(const Streamer& streamer) const {
  StreamStatus status = streamer.status();
  if (isCutOff()) status.state = PackmlState::Execute;
  if (is_repeatable_) return status;
  if (status.state != PackmlState::Complete) status.state = PackmlState::Aborted;
  status.lines_sent = std::min(status.lines_sent, job_.lines_total);
  status.lines_acknowledged = std::min(status.lines_acknowledged, job_.lines_total);
  return status;
}

}  // namespace lamina
