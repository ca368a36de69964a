// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "lamina/streaming/journal/job_journal.hpp"
#include "streaming/journal/progress_file.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {

/// The progress file of a print that a server runs by itself: the uploaded file, its name, and how much of it
/// the machine last reported as read. It is on disk before the print starts. If the disk fails the print goes
/// on without it.
class UploadJournal {
 public:
  /// @throws FileError if the program is gone
  UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port);

  /// Stores the progress; to be called before the job's request is sent.
  void keep(const UploadJob& job);
  /// The job's status, completed by the last progress of a print that is gone and by a failure of the file.
  StreamStatus withWhatIsKnown(const UploadJob& job) const;

 private:
  void begin(const UploadJob& job);

  StreamJournal where_;
  JournalledJob job_;
  JobProgress kept_;
  std::unique_ptr<ProgressFile> file_;
  std::string failure_;
};

}  // namespace lamina
