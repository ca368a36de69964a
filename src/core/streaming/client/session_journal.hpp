// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lamina/streaming/client/streamer.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "streaming/journal/journal_writer.hpp"

namespace lamina {

/// The progress file of one session. A disk that fails does not stop the machine: the job goes on without.
class SessionJournal {
 public:
  /// @throws FileError if the program is gone
  /// @param revision  of the lines on their way, or null: their progress is kept where a record tells of them
  SessionJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                 std::shared_ptr<const ProgramRevision> revision);

  /// The order with what the journal adds to it: where lines count from, and what was left behind.
  StreamOrder placed(StreamOrder order) const;
  /// To be called before what the streamer has put out leaves.
  void keep(const Streamer& streamer, double now);
  /// Whether the link was lost and never came back for the safe stop: the machine has lived on, so that the
  /// file says nothing of an abort, and the job can be gone on with.
  bool isCutOff() const { return writer_ && is_cut_off_ && !is_stop_sent_; }
  /// Why nothing is kept any more; empty while all is well.
  const std::string& failure() const { return failure_; }

 private:
  void begin(const Streamer& streamer);
  void followLink(const Streamer& streamer);
  /// As of a job that may have any number of lines, where it is revised.
  std::uint64_t mostLines() const;

  StreamJournal where_;
  JournalledJob job_;
  std::shared_ptr<const ProgramRevision> revision_;
  std::unique_ptr<JournalWriter> writer_;
  bool has_begun_ = false;
  bool is_cut_off_ = false;    ///< the link is lost
  bool is_stop_sent_ = false;  ///< a safe stop may have reached the machine
  std::string failure_;
};

}  // namespace lamina
