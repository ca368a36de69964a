// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/journal/job_progress.hpp"

namespace lamina {

inline constexpr double kLongestWrite = 10.0;  ///< [s] after which a disk counts as unresponsive

/// A progress file that is open for writing. A record is on disk when `write` returns.
class ProgressFile {
 public:
  /// Creates the file. An earlier one is replaced when the new one is on disk.
  /// @throws FileError
  ProgressFile(const std::string& path, const JournalledJob& job, const JobProgress& progress);
  ~ProgressFile();
  ProgressFile(ProgressFile&& other) noexcept;
  ProgressFile& operator=(ProgressFile&&) = delete;
  ProgressFile(const ProgressFile&) = delete;
  ProgressFile& operator=(const ProgressFile&) = delete;

  /// Replaces the older of the two records, and sets the sequence.
  /// @throws FileError if it cannot be written
  void write(JobProgress progress);

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint32_t job_crc_ = 0;
  std::uint64_t sequence_ = 0;
};

/// Function that writes the progress of a job, stamped with the present time, to the file of a journal. Its
/// first call creates the file, and keeps what was unfinished there unless the job resumes it
/// (`keepUnfinished`): nothing waits for a disk before.
std::function<void(const JobProgress& progress)> fileWriter(const StreamJournal& where,
                                                            const JournalledJob& job);

}  // namespace lamina
