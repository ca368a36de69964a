// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/streaming/job/stream_job.hpp"
#include "streaming/journal/progress_file.hpp"

namespace lamina {

/// Keeps a progress file by a thread of its own, so that who streams waits for the disk only where lines
/// would leave that the file does not know of. These are announced well ahead: by 256 lines or those of the
/// last 0.2 s, whichever is more. What was acknowledged follows ten times a second, and at the end of layers.
class JournalWriter {
 public:
  JournalWriter(ProgressFile file, const JobProgress& known, std::uint64_t lines_total);
  /// Writes what is still to be written.
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// To be called before the lines leave that the status counts as sent: returns when the file knows of them.
  /// @param now  [s] since any start
  /// @throws FileError once, if the file can no longer be written; from then on nothing is kept
  void record(const StreamStatus& status, double now);

 private:
  void run();
  void measureRate(std::uint64_t sent, double now);
  void require(std::uint64_t sent);

  ProgressFile file_;
  const std::uint64_t lines_total_;
  const std::uint64_t taken_before_;  ///< by earlier sessions
  std::uint64_t ahead_;
  std::uint64_t measured_from_;      ///< lines sent at measured_since_
  double measured_since_ = -1.0;     ///< [s]; negative before the first call
  double next_acknowledgement_ = 0;  ///< [s]
  JobProgress asked_;                ///< the last that the thread was given
  bool has_failed_ = false;

  std::mutex mutex_;  ///< of everything below
  std::condition_variable has_changed_;
  JobProgress wanted_;
  bool is_outdated_ = false;  ///< the file does not say what is wanted
  bool is_over_ = false;
  std::uint64_t kept_sent_;  ///< as the file says
  std::string failure_;
  std::thread thread_;
};

}  // namespace lamina
