// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/upload_journal.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "streaming/journal/progress_file.hpp"

namespace lamina {
namespace {

/// Whether the machine was lost from sight, and prints on.
bool isOutOfSight(const StreamStatus& status) {
  return status.failure.code == ErrorCode::Disconnected &&
         (status.state == PackmlState::Aborting || status.state == PackmlState::Aborted);
}

JobProgress progressOf(const StreamStatus& status) {
  JobProgress progress;
  progress.sent_through = status.lines_total;
  progress.taken_through = status.lines_acknowledged;
  progress.layer = status.layer;
  progress.state = isOutOfSight(status) ? PackmlState::Execute : status.state;
  return progress;
}

}  // namespace

UploadJournal::UploadJournal(const StreamJournal& where, const StreamableProgram& program,
                             const std::string& port)
    : UploadJournal(where, program, port,
                    [where](const JournalledJob& job) { return fileWriter(where, job); }) {}

UploadJournal::UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                             Writer writer)
    : where_(std::move(where)), writer_(std::move(writer)) {
  if (where_.path.empty()) return;
  job_ = describedJob(program, port);
  job_.execution = where_.unfinished ? where_.unfinished->job.execution : where_.execution;
}

void UploadJournal::begin(const UploadJob& job) {
  job_.protocol = job.firmware();
  job_.firmware_name = job.status().firmware_name;
  job_.uploaded_as = job.printedFile();
  keeper_ = std::make_unique<ProgressKeeper>(writer_(job_), kLongestWrite);
}

void UploadJournal::keep(const UploadJob& job, double now) {
  // What fails before the print may have been started leaves what was known of the one before.
  if (where_.path.empty() || !failure_.empty() || !(keeper_ || job.mayBeStarted())) return;
  const JobProgress known = progressOf(job.status());
  const bool is_kept = keeper_ && known.taken_through == kept_.taken_through && known.layer == kept_.layer &&
                       known.state == kept_.state;
  if (!keeper_) begin(job);
  if (!is_kept) keeper_->keep(known, now);
  kept_ = known;
  const std::string failure = keeper_->failure(now);
  if (failure.empty()) return;
  failure_ = failure + "; the print goes on, but how far it is is no longer kept";
  const bool is_stated = where_.unfinished || keeper_->hasWritten();
  if (!is_stated && !job_.execution.empty())
    prohibition_ = failure + "; execution " + job_.execution +
                   " was not started, since nothing states that it has begun";
  keeper_.reset();
}

/// Of a print that is under way nothing waits, and a stop least of all.
bool UploadJournal::isAwaited(const UploadJob& job) const {
  return keeper_ && job.status().state == PackmlState::Starting && !keeper_->hasWritten();
}

StreamStatus UploadJournal::withWhatIsKnown(const UploadJob& job) const {
  StreamStatus status = job.status();
  if (!failure_.empty() && prohibition_.empty()) status.message = failure_;
  const bool is_not_there = isFinal(status.state) && !job.mayBeStarted();
  if (where_.unfinished && is_not_there)
    status.failure.message += "; known is: " + describeProgress(*where_.unfinished);
  return status;
}

}  // namespace lamina
