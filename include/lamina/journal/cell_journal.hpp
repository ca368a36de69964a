// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// State of a job in the queue, by the number of ISA-95 (OPC 10031-4).
enum class JobState : std::uint8_t {
  NotAllowedToStart = 1,  ///< waits for somebody to release it
  AllowedToStart = 2,
  Running = 3,
  Interrupted = 4,  ///< held, suspended, or cut off and resumable
  Ended = 5,
  Aborted = 6,
};

/// `NotAllowedToStart` and so on.
const char* toString(JobState state);

/// A file that a job needs, kept by the digest of its bytes.
struct Artefact {
  std::string sha256;
  std::uint64_t bytes = 0;
  std::string
      kind;  ///< "program", "mesh", "settings", "machine", "startup", "calibration", "loop", "version"
  std::string name;
};

/// SHA-256 over the lines `kind digest` in alphabetical order: the same files make the same job.
std::string jobDigest(const std::vector<Artefact>& artefacts);

struct NewJob {
  std::string name;
  std::string part;
  std::string machine;
  std::vector<Artefact> artefacts;
  std::string created_by;
  std::int32_t layers = 0;  ///< of the program; 0 if it does not say
};

struct QueuedJob {
  std::int64_t id = 0;
  std::string name;
  std::string part;
  std::string machine;
  std::string digest;
  JobState state = JobState::NotAllowedToStart;
  std::int64_t position = 0;  ///< in the queue, the lowest first
  std::string created_by;
  std::string released_by;
  std::vector<Artefact> artefacts;
  std::int32_t layers = 0;  ///< of the program; 0 if it does not say
};

/// How far an execution of a job is.
struct ExecutionProgress {
  std::uint64_t sent_through = 0;   ///< no line beyond has left
  std::uint64_t taken_through = 0;  ///< certainly taken by the machine
  std::int32_t layer = -1;
  double path_mm = 0.0;
  double laid_mm3 = 0.0;
};

/// An execution without an end: the journal was cut off, or it is under way.
struct OpenExecution {
  std::int64_t id = 0;
  std::int64_t job = 0;
  int attempt = 1;
  double started_s = 0.0;
  ExecutionProgress progress;
};

/// A change of state or mode, as `UnitChange` has it, in numbers.
struct TransitionRow {
  double time_s = 0.0;  ///< since 1970, UTC, as all times of the journal
  int mode = 0;
  int from = 0;
  int to = 0;
  int command = 0;  ///< 0 for none
  std::string source;
  std::string reason;
};

struct AlarmRow {
  double time_s = 0.0;
  int alarm = 0;
  double value = 0.0;
  char category = 'I';
  std::string message;
};

/// Something that somebody asked for, and what became of it.
struct AuditRow {
  double time_s = 0.0;
  std::string who;
  std::string from;  ///< address or program
  std::string what;
  std::string result;
};

/// The journal of a cell: jobs, executions, what happened, who asked for what. A database file (SQLite) of
/// one process and thread; readers beside it may open it for reading. Every call that makes a change returns
/// once the change is on the disk. A kill or a power cut therefore loses no change whose call has returned.
///
/// A job that is in the queue is never lost, and an execution is begun once: `begin` of a job that runs is
/// refused.
class CellJournal {
 public:
  /// Opens the journal, makes it, or brings an older one up to date. A damaged one is moved aside to a name
  /// with
  /// `.damaged` and a number, and a new one is begun.
  /// @throws FileError if the folder or file cannot be written, or a newer version has written it
  explicit CellJournal(const std::string& path);

  /// Opens a journal for reading, also while its cell works. What would change it is refused.
  /// @throws FileError if it cannot be read, is damaged, or is not of this version
  static CellJournal read(const std::string& path);
  ~CellJournal();
  CellJournal(CellJournal&&) noexcept;
  CellJournal& operator=(CellJournal&&) noexcept;

  /// Where the damaged journal is now; empty if it was not damaged.
  const std::string& movedAside() const { return moved_aside_; }

  /// Adds a job at the end of the queue, not allowed to start.
  std::int64_t addJob(const NewJob& job, double time_s);
  /// All jobs that have not ended, by position.
  std::vector<QueuedJob> queue() const;
  /// @throws InvalidInput if there is no such job
  QueuedJob job(std::int64_t id) const;
  /// The first of the queue that is allowed to start.
  std::optional<QueuedJob> next() const;

  /// @throws InvalidInput if the job is not waiting for it, naming its state
  void release(std::int64_t id, const std::string& by, double time_s);
  void revoke(std::int64_t id, const std::string& by, double time_s);
  /// Before all others of the queue.
  void moveToFront(std::int64_t id, const std::string& by, double time_s);
  /// Takes a job that does not run out of the queue. Its executions stay in the journal.
  void remove(std::int64_t id, const std::string& by, double time_s);

  /// Begins an execution of a job that is allowed to start. An interrupted execution is continued by `goOn`.
  /// @throws InvalidInput in any other state
  std::int64_t begin(std::int64_t job, const std::string& by, double time_s);
  void setProgress(std::int64_t execution, const ExecutionProgress& progress, double time_s);
  /// The job of the execution waits: held, suspended or cut off.
  void interrupt(std::int64_t execution, const std::string& reason, double time_s);
  /// The interrupted execution goes on.
  void goOn(std::int64_t execution, double time_s);
  /// @param outcome  Ended or Aborted
  void end(std::int64_t execution, JobState outcome, const std::string& reason, double time_s);
  std::optional<OpenExecution> open() const;

  void add(const TransitionRow& row);
  void add(const AlarmRow& row);
  /// Acknowledges all rows of that alarm that wait for it.
  void acknowledgeAlarm(int alarm, const std::string& by, double time_s);
  void endAlarm(int alarm, double time_s);
  std::vector<TransitionRow> transitions(std::size_t most) const;  ///< the last, oldest first
  std::vector<AlarmRow> alarms(std::size_t most) const;

  /// Numbers by name that survive: counters and settings of the unit.
  void setCounters(const std::map<std::string, double>& counters);
  std::map<std::string, double> counters() const;

  /// Each row holds the digest of itself and of the row before.
  void add(const AuditRow& row);
  /// The first row of the audit whose digest is not its own, counted from 1; nothing if the chain is whole.
  std::optional<std::int64_t> firstBadAudit() const;

  /// Makes all changes of the calls within, or none of them.
  void together(const std::function<void()>& changes);

  /// Copies the journal as it is now, whole, under another name.
  void backUp(const std::string& path) const;

 private:
  friend class ExecutionLog;
  struct Store;
  CellJournal();

  std::string moved_aside_;
  std::unique_ptr<Store> store_;
};

}  // namespace lamina
