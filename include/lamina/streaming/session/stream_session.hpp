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

/// The port by which a machine is reached.
struct MachinePort {
  /// "tcp:host:port", "http://host:port" of a print server, or the path of a serial port or pseudo-terminal.
  std::string name;
  int baud = 115200;  ///< of a serial port
};

/// Whether a port is a print server, to which a program is uploaded as a whole.
/// @throws InvalidInput for a web address of a scheme that is not supported: "https://..."
bool isPrintServer(const MachinePort& port);

/// Options of a session.
struct SessionOptions {
  /// Called with each line that the machine sends, from the session's thread; a print server sends none.
  ReplyListener heard;
  /// The progress file, from `beginJournal` for a new job, `resumeJournal` for a resumed job, `followJournal`
  /// for a followed print.
  StreamJournal journal;
  JobStart start = JobStart::New;  ///< used for a print server only; for other ports the journal decides
  /// Changes the lines before they are sent; null if they are sent unchanged. The progress of a job with a
  /// revision is kept only if the revision keeps a record from which the lines can be made again; of any
  /// other only its execution is, as of a job that cannot be resumed.
  std::shared_ptr<ProgramRevision> revision = nullptr;
};

/// The journal of a job at a port: `beginJournal` for a new job; to resume one, `followJournal` on a print
/// server and `resumeJournal` at any other port.
/// @param path  path of the progress file, from `journalPath`
/// @throws as `beginJournal`, `resumeJournal` and `followJournal`
StreamJournal journalFor(const std::string& path, const StreamableProgram& program, const MachinePort& port,
                         JobStart start);

/// A job that runs in a thread of its own: either a program is streamed to a port, or it is uploaded to a
/// print server, which prints it by itself. All functions may be called from any thread.
class StreamSession {
 public:
  /// Called with the job's status at each change of state, in order, and at least ten times a second while
  /// the job advances. It is called from the session's thread and must not wait for the session.
  using Observer = std::function<void(const StreamStatus&)>;

  /// Opens the port and starts to stream.
  /// @throws Disconnected naming the port if no machine is there
  /// @throws FileError if the file of the program, or of the password, is gone
  /// @throws InvalidProgram if the firmware that the settings name, or the print server, would misread the
  ///   program
  /// @throws InvalidConfig if a revision is given for a print server, for firmware that accepts no revised
  ///   lines, or for an unfinished job
  StreamSession(const StreamableProgram& program, const StreamSettings& settings, const MachinePort& port,
                Observer observer, SessionOptions options = {});
  /// Aborts a job that is not over, and waits for the safe stop.
  ~StreamSession();
  StreamSession(const StreamSession&) = delete;
  StreamSession& operator=(const StreamSession&) = delete;

  /// Requests a hold after the lines under way, or before the first one; without effect unless the job is in
  /// Starting or Execute.
  void pause();
  /// Requests that the job continues; without effect unless it is in Starting, Holding or Held.
  void resume();
  /// Changes a setting of the running job; waits until the session's thread has accepted or refused it.
  /// @return empty if it is accepted, else the reason in words. If a print server refuses it later, its
  ///   answer is the status's `message`.
  std::string change(const LiveChange& change);
  /// Sends the machine questions between two lines of the job (`StreamJob::ask`); `SessionOptions::heard` is
  /// called with the answers. A question is dropped if `StreamJob::ask` returns false, for example while the
  /// previous question is not answered.
  /// @param commands  commands, one on each line
  void ask(const std::string& commands);
  /// Requests a safe stop; the job ends in Aborted.
  void abort(const Failure& why);

  StreamStatus status() const;
  bool isOver() const;
  /// Waits for the end of the job.
  /// @return false if it has not ended within `timeout_s`
  bool waitFor(double timeout_s) const;

 private:
  std::unique_ptr<class SessionKind> kind_;
};

/// Does nothing if a job has no failure.
/// @throws otherwise the error that its failure describes
void throwIfFailed(const StreamStatus& status);

}  // namespace lamina
