// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "lamina/streaming/journal/job_progress.hpp"

namespace lamina {

/// Keeps the latest progress on disk, in a thread of its own. Callers wait for the disk in `await` only, and
/// no longer than the patience, since they have a machine to stop.
class ProgressKeeper {
 public:
  /// Function that returns once the progress is on disk.
  /// @throws FileError
  using Write = std::function<void(const JobProgress& progress)>;

  /// @param write  called in the keeper's thread, which outlives the keeper while such a call lasts
  /// @param patience_s  longest duration of a write
  /// @param written  progress that is on disk already; nothing if there is none
  ProgressKeeper(Write write, double patience_s, const std::optional<JobProgress>& written = {});
  /// Waits for the last progress to be written, if the disk answers in time.
  ~ProgressKeeper();
  ProgressKeeper(const ProgressKeeper&) = delete;
  ProgressKeeper& operator=(const ProgressKeeper&) = delete;

  /// States the progress, in place of what was not written yet. Waits for nothing.
  /// @param now  [s] since any fixed time
  void keep(const JobProgress& progress, double now);
  /// Whether anything is on disk.
  bool hasWritten() const;
  /// Why the file is not written any more; empty if it is.
  std::string failure(double now);
  /// Returns when the progress on disk is enough.
  /// @throws FileError if the file cannot be written, or not in time; nothing is written from then on
  void await(const std::function<bool(const JobProgress& written)>& isEnough);

 private:
  /// State shared with the thread. It outlives the keeper if the disk does not answer, since a thread that
  /// waits for a disk cannot be ended.
  struct Shared {
    Write write;       ///< called by the thread only
    std::mutex mutex;  ///< guards everything below
    std::condition_variable has_changed;
    std::optional<JobProgress> wanted;  ///< progress that is not being written yet
    double wanted_s = 0.0;              ///< [s] when `wanted` was stated
    std::optional<double> since_s;      ///< [s] when the progress being written was stated
    std::optional<JobProgress> written;
    bool is_over = false;
    bool has_ended = false;  ///< whether the thread has ended
    std::string failure;
  };

  static void run(Shared& shared);
  static void writeAll(Shared& shared);
  std::string giveUp();

  const double patience_s_;
  std::shared_ptr<Shared> shared_;
  bool is_given_up_ = false;  ///< the disk was waited for in vain
  std::thread thread_;
};

}  // namespace lamina
