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

/// Writes a progress file in a thread of its own. The file announces lines before they are sent: 256 lines
/// ahead or the number sent in the last 0.2 s, whichever is more. The streamer waits for the disk only before
/// it sends lines beyond those announced. Acknowledged lines are written ten times a second and at the end of
/// layers.
class JournalWriter {
 public:
  JournalWriter(ProgressFile file, const JobProgress& known, std::uint64_t lines_total);
  /// Writes the last progress.
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// Returns when the file announces all lines that the status counts as sent; to be called before they are
  /// sent.
  /// @param now  [s] since any fixed time
  /// @throws FileError once, if the file can no longer be written; nothing is written from then on
  void record(const StreamStatus& status, double now);

 private:
  void run();
  void measureRate(std::uint64_t sent, double now);
  void require(std::uint64_t sent);

  ProgressFile file_;
  const std::uint64_t lines_total_;
  const std::uint64_t taken_before_;  ///< number of lines acknowledged in earlier sessions
  std::uint64_t ahead_;
  std::uint64_t measured_from_;      ///< lines sent at measured_since_
  double measured_since_ = -1.0;     ///< [s]; negative before the first call
  double next_acknowledgement_ = 0;  ///< [s]
  JobProgress asked_;                ///< the last progress passed to the thread
  bool has_failed_ = false;

  std::mutex mutex_;  ///< of everything below
  std::condition_variable has_changed_;
  JobProgress wanted_;
  bool is_outdated_ = false;  ///< whether the file lacks the last progress
  bool is_over_ = false;
  std::uint64_t kept_sent_;  ///< number of sent lines that the file states
  std::string failure_;
  std::thread thread_;
};

}  // namespace lamina
