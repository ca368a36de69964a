// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "lamina/streaming/journal/job_journal.hpp"
#include "streaming/journal/progress_file.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {

/// The progress file of a print that a server runs by itself: what was uploaded under which name, and how far
/// the machine has read it by its own last word. It is on the disk before the print is started. A disk that
/// fails does not stop the machine.
class UploadJournal {
 public:
  /// @throws FileError if the program is gone
  UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port);

  /// To be called before what the job asks for leaves.
  void keep(const UploadJob& job);
  /// The status as others see it: with what was known of a print that is no longer there, and why nothing is
  /// kept any more.
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
