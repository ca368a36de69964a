// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/motion_time.hpp"

namespace lamina {

/// Reads a program's file a thousand lines ahead in a thread of its own, so that a slow disk or network
/// folder does not stop the machine. It ends early if the file is changed, since its new content was not
/// checked.
class ReadAhead {
 public:
  /// @throws FileError if the file is gone
  explicit ReadAhead(const StreamableProgram& program);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// The next line; waits for it if necessary. None at the end.
  std::optional<ProgramLine> next();

 private:
  using Batch = std::vector<ProgramLine>;

  void run();
  Batch readBatch();
  bool hand(Batch batch);

  StreamableProgram program_;
  ProgramCursor cursor_;
  MotionTime time_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> read_;
  bool is_over_ = false;  ///< nothing more is read, or wanted
  Batch current_;
  std::size_t given_ = 0;  ///< lines of the current batch
  std::thread thread_;
};

}  // namespace lamina
