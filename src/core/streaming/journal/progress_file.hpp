// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/streaming/journal/job_progress.hpp"

namespace lamina {

/// A progress file that is open for writing. Every record is on the disk when its write returns.
class ProgressFile {
 public:
  /// Makes the file; what was there stays until the new one is on the disk.
  /// @throws FileError
  ProgressFile(const std::string& path, const JournalledJob& job, const JobProgress& progress);
  ~ProgressFile();
  ProgressFile(ProgressFile&& other) noexcept;
  ProgressFile& operator=(ProgressFile&&) = delete;
  ProgressFile(const ProgressFile&) = delete;
  ProgressFile& operator=(const ProgressFile&) = delete;

  /// Replaces the older of the two records. The sequence is counted here.
  /// @throws FileError if the disk does not take it
  void write(JobProgress progress);

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint32_t job_crc_ = 0;
  std::uint64_t sequence_ = 0;
};

}  // namespace lamina
