// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lamina/streaming/journal/job_journal.hpp"
#include "streaming/journal/progress_keeper.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {

/// The progress file of a print that a server runs by itself: the uploaded file, its name, and how much of it
/// the machine last reported as read. It is on disk before the print starts. If the disk fails, or does not
/// answer for `kLongestWrite`, the print goes on without it. No call waits for the disk.
class UploadJournal {
 public:
  /// Function that writes the progress of a job, its file first: called by a thread that may wait for a disk.
  using Writer = std::function<ProgressKeeper::Write(const JournalledJob& job)>;

  /// @throws FileError if the program is gone
  UploadJournal(const StreamJournal& where, const StreamableProgram& program, const std::string& port);
  /// As above, with another writer than that of the file.
  UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                Writer writer);

  /// States the progress; to be called before the job's request is sent.
  void keep(const UploadJob& job, double now);
  /// Whether the job's request has to wait, since the file does not yet say that the print may be started. To
  /// be asked after `keep`.
  bool isAwaited(const UploadJob& job) const;
  /// Why the print must not be started: the file could not state the execution that is to begin, and who asks
  /// for it once more would have it printed once more. Empty if it may. To be asked after `keep`.
  const std::string& prohibition() const { return prohibition_; }
  /// The job's status, completed by the last progress of a print that is gone and by a failure of the file.
  StreamStatus withWhatIsKnown(const UploadJob& job) const;

 private:
  void begin(const UploadJob& job);

  StreamJournal where_;
  Writer writer_;
  JournalledJob job_;
  JobProgress kept_;
  std::unique_ptr<ProgressKeeper> keeper_;
  std::string failure_;
  std::string prohibition_;
};

}  // namespace lamina
