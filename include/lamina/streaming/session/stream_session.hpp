// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lamina/streaming/job/job_start.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/session/streamer.hpp"

namespace lamina {

/// The port at which a machine is.
struct MachinePort {
  /// "tcp:host:port", "http://host:port" of a print server, or the path of a serial port or pseudo-terminal
  std::string name;
  int baud = 115200;
};

/// Whether a port is a print server, which takes a whole program as an upload.
/// @throws InvalidInput for a web address of a scheme that is not supported: "https://..."
bool isPrintServer(const MachinePort& port);

/// Options of a session.
struct SessionOptions {
  ReplyListener heard;    ///< given every line of the machine, from the session's thread; a print server says
                          ///< none
  StreamJournal journal;  ///< where the progress is kept (`beginJournal`), and the job to go on with
                          ///< (`resumeJournal`), or the print to follow (`followJournal`)
  JobStart start = JobStart::New;  ///< of no effect at a serial port, where the journal says it
  /// Changes the lines before they are sent; null if they are sent unchanged. Progress of a job with a
  /// revision is kept only if the revision keeps a record, from which the lines can be made again.
  std::shared_ptr<ProgramRevision> revision = nullptr;
};

/// The journal of a job at a port, by how the job starts.
/// @param path  as `journalPath`
/// @throws as `beginJournal`, `resumeJournal` and `followJournal`
StreamJournal journalFor(const std::string& path, const StreamableProgram& program, const MachinePort& port,
                         JobStart start);

/// A job in a thread of its own: a streamer at a port, or an upload to a print server, which prints by
/// itself. All calls may come from any thread.
class StreamSession {
 public:
  /// Called with the job's status at each change of state, in order, and at least ten times a second while
  /// the job advances. It runs in the session's thread and must not wait for the session.
  using Observer = std::function<void(const StreamStatus&)>;

  /// Opens the port and starts to stream.
  /// @throws Disconnected naming the port if no machine is there
  /// @throws FileError if the program is gone, or the password's file
  /// @throws InvalidProgram of a print server, if it would misread the program
  /// @throws InvalidConfig if a revision is given for a print server, for firmware that takes no revised
  ///   lines, or for an unfinished job
  StreamSession(const StreamableProgram& program, const StreamSettings& settings, const MachinePort& port,
                Observer observer, SessionOptions options = {});
  /// Aborts a job that is not over, and waits for the safe stop.
  ~StreamSession();
  StreamSession(const StreamSession&) = delete;
  StreamSession& operator=(const StreamSession&) = delete;

  /// Asks to hold after the lines under way, or before the first one; without effect unless in Starting or
  /// Execute.
  void pause();
  /// Asks to go on; without effect unless in Starting, Holding or Held.
  void resume();
  /// Changes a setting of the running job; waits until the session's thread has taken it.
  /// @return why it is refused, in words; empty if it is taken. A later answer of a print server is in the
  ///   status's message.
  std::string change(const LiveChange& change);
  /// Asks the machine, one after the other, between two lines of the job; its answers come to whoever hears
  /// it. Without effect where `StreamJob::ask` is.
  /// @param commands  one on each line
  void ask(const std::string& commands);
  /// Asks for a safe stop; the job ends in Aborted.
  void abort(const Failure& why);

  StreamStatus status() const;
  bool isOver() const;
  /// Waits for the end of the job.
  /// @return false if it has not ended within `timeout_s`
  bool waitFor(double timeout_s) const;

 private:
  std::unique_ptr<class SessionKind> kind_;
};

/// Throws the failure of a job that is over, unless it is Complete.
/// @throws the error that its failure stands for
void throwIfFailed(const StreamStatus& status);

}  // namespace lamina
