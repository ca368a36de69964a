// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/streaming/job/stream_job.hpp"
#include "streaming/journal/progress_keeper.hpp"

namespace lamina {

/// Writes a progress file in a thread of its own, in which it is also created. The file announces lines
/// before they are sent: 256 lines ahead or the number sent in the last 0.2 s, whichever is more. The
/// streamer waits for the disk only before it sends lines beyond those announced, and not for ever: it has a
/// machine to stop. Acknowledged lines are written ten times a second and at the end of layers. The
/// destructor writes the last progress, if the disk answers in time.
class JournalWriter {
 public:
  using Write = ProgressKeeper::Write;

  /// @param write  called in the writer's thread, which outlives the writer while such a call lasts; first by
  ///   the first call of `record`
  /// @param known  progress before the job
  /// @param patience_s  longest wait for the disk
  JournalWriter(Write write, const JobProgress& known, std::uint64_t lines_total, double patience_s);

  /// Returns when the file announces all lines that the status counts as sent; to be called before they are
  /// sent.
  /// @param now  [s] since any fixed time
  /// @throws FileError once, if the file can no longer be written, or not in time; nothing is announced from
  ///   then on
  void record(const StreamStatus& status, double now);

 private:
  void measureRate(std::uint64_t sent, double now);
  void require(std::uint64_t sent);

  const std::uint64_t lines_total_;
  const std::uint64_t taken_before_;  ///< number of lines acknowledged in earlier sessions
  std::uint64_t ahead_;
  std::uint64_t measured_from_;      ///< lines sent at measured_since_
  double measured_since_ = -1.0;     ///< [s]; negative before the first call
  double next_acknowledgement_ = 0;  ///< [s]
  JobProgress asked_;                ///< the last progress passed to the thread, if any was
  bool has_asked_ = false;
  bool has_failed_ = false;
  ProgressKeeper keeper_;
};

}  // namespace lamina
