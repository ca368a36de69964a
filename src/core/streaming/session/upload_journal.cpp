// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/upload_journal.hpp"

#include <utility>

#include "lamina/base/error.hpp"

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

UploadJournal::UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port)
    : where_(std::move(where)) {
  if (where_.path.empty()) return;
  job_ = describedJob(program, port);
  job_.execution = where_.unfinished ? where_.unfinished->job.execution : where_.execution;
}

void UploadJournal::begin(const UploadJob& job) {
  if (!where_.unfinished) keepUnfinished(where_.path);
  job_.protocol = job.firmware();
  job_.firmware_name = job.status().firmware_name;
  job_.uploaded_as = job.printedFile();
  file_ = std::make_unique<ProgressFile>(where_.path, job_, stampedNow(kept_));
}

void UploadJournal::keep(const UploadJob& job) {
  // What fails before the print may have been started leaves what was known of the one before.
  if (where_.path.empty() || !failure_.empty() || !(file_ || job.mayBeStarted())) return;
  const JobProgress known = progressOf(job.status());
  const bool is_kept = file_ && known.taken_through == kept_.taken_through && known.layer == kept_.layer &&
                       known.state == kept_.state;
  if (is_kept) return;
  kept_ = known;
  try {
    if (file_)
      file_->write(stampedNow(kept_));
    else
      begin(job);
  } catch (const Error& error) {
    failure_ = std::string(error.what()) + "; the print goes on, but how far it is is no longer kept";
    file_.reset();
  }
}

StreamStatus UploadJournal::withWhatIsKnown(const UploadJob& job) const {
  StreamStatus status = job.status();
  if (!failure_.empty()) status.message = failure_;
  const bool is_not_there = isFinal(status.state) && !job.mayBeStarted();
  if (where_.unfinished && is_not_there)
    status.failure.message += "; known is: " + describeProgress(*where_.unfinished);
  return status;
}

}  // namespace lamina
