// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "lamina/streaming/job/program_revision.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "streaming/journal/journal_writer.hpp"
#include "streaming/journal/progress_file.hpp"

namespace lamina {

/// The progress file of one session. If the disk fails, or does not answer for the patience, the job goes on
/// without it. No call waits longer for a disk.
class SessionJournal {
 public:
  /// Function that writes the progress of a job, its file first: called by a thread that may wait for a disk.
  using Writer = std::function<ProgressKeeper::Write(const JournalledJob& job)>;

  /// @throws FileError if the program is gone
  /// @param revision  of the lines, or null; without a record of revised lines only executions are stated, as
  ///   jobs that cannot go on
  SessionJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                 std::shared_ptr<const ProgramRevision> revision);
  /// Replaces the writer of the file by another one.
  void writeBy(Writer writer, double patience_s) {
    write_ = std::move(writer);
    patience_s_ = patience_s;
  }

  /// The order, completed by the first line number and the unfinished job.
  StreamOrder placed(StreamOrder order) const;
  /// Stores the progress; to be called before the streamer's output is sent.
  void keep(const Streamer& streamer, double now);
  /// Whether the link was lost and did not come back for the safe stop. The file then states no abort, and
  /// the job can be resumed on the machine that went on.
  bool isCutOff() const { return writer_ && is_cut_off_ && !is_stop_sent_ && is_repeatable_; }
  /// Why progress is no longer stored; empty if it is.
  const std::string& failure() const { return failure_; }
  /// Whether the file does not state the execution that is to begin, so that no line of it may be sent: who
  /// asks for it once more would have it begun once more.
  bool forbidsTheFirstLine() const { return !failure_.empty() && !where_.execution.empty() && !is_stated_; }

 private:
  void begin(const Streamer& streamer);
  void followLink(const Streamer& streamer);
  StreamStatus stated(const Streamer& streamer) const;
  /// As of a job that may have any number of lines, where it is revised.
  std::uint64_t mostLines() const;

  StreamJournal where_;
  Writer write_;
  double patience_s_ = kLongestWrite;
  JournalledJob job_;
  std::shared_ptr<const ProgramRevision> revision_;
  std::unique_ptr<JournalWriter> writer_;
  bool is_repeatable_ = true;  ///< whether the lines that are sent can be made again
  bool is_stated_ = false;     ///< whether the file states the job
  bool has_begun_ = false;
  bool is_cut_off_ = false;    ///< the link is lost
  bool is_stop_sent_ = false;  ///< a safe stop may have reached the machine
  std::string failure_;
};

}  // namespace lamina
