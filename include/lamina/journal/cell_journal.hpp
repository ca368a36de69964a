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

/// State of a job in the queue; values are the numbers of ISA-95 (OPC 10031-4).
enum class JobState : std::uint8_t {
  NotAllowedToStart = 1,  ///< waits for somebody to release it
  AllowedToStart = 2,
  Running = 3,
  Interrupted = 4,  ///< held, suspended, or cut off and resumable
  Ended = 5,
  Aborted = 6,
};

/// The name of the state, as above.
const char* toString(JobState state);

/// A file that a job needs, stored under the digest of its bytes.
struct Artefact {
  std::string sha256;
  std::uint64_t bytes = 0;
  std::string
      kind;  ///< "program", "mesh", "settings", "machine", "startup", "calibration", "loop", "version"
  std::string name;
};

/// Digest of a job: SHA-256 over the lines `kind digest` of its artefacts in alphabetical order. Jobs with
/// the same files have the same digest.
std::string jobDigest(const std::vector<Artefact>& artefacts);

/// A job to be added to the queue.
struct NewJob {
  std::string name;
  std::string part;
  std::string machine;
  std::vector<Artefact> artefacts;
  std::string created_by;
  std::int32_t layers = 0;  ///< number of layers of the program; 0 if it does not state it
};

/// A job in the journal.
struct QueuedJob {
  std::int64_t id = 0;
  std::string name;
  std::string part;
  std::string machine;
  std::string digest;
  JobState state = JobState::NotAllowedToStart;
  std::int64_t position = 0;  ///< position in the queue, the lowest first
  std::string created_by;
  std::string released_by;
  std::vector<Artefact> artefacts;
  std::int32_t layers = 0;  ///< number of layers of the program; 0 if it does not state it
};

/// Progress of an execution of a job.
struct ExecutionProgress {
  std::uint64_t sent_through = 0;   ///< number of the last program line that may have been sent
  std::uint64_t taken_through = 0;  ///< number of the last line that the machine has certainly taken
  std::int32_t layer = -1;
  double path_mm = 0.0;        ///< length of beads laid
  double deposited_mm3 = 0.0;  ///< volume of material used
};

/// An execution that has not ended: it is running or interrupted, or the process was killed.
struct OpenExecution {
  std::int64_t id = 0;
  std::int64_t job = 0;
  int attempt = 1;
  double started_s = 0.0;
  ExecutionProgress progress;
};

/// A change of the unit's state or mode, as in `UnitChange`, by numbers.
struct TransitionRow {
  double time_s = 0.0;  ///< since 1970, UTC, as all times of the journal
  int mode = 0;
  int from = 0;
  int to = 0;
  int command = 0;  ///< command that caused it; 0 for none
  std::string source;
  std::string reason;
};

/// An alarm that was raised.
struct AlarmRow {
  double time_s = 0.0;
  int alarm = 0;
  double value = 0.0;
  char category = 'I';
  std::string message;
  std::int64_t execution = 0;  ///< execution open when the row was added, in returned rows; 0 for none
};

/// An entry of the audit: who asked for what, and with which result.
struct AuditRow {
  double time_s = 0.0;
  std::string who;
  std::string from;  ///< address or program
  std::string what;
  std::string result;
};

/// The journal of a cell: jobs, executions, events, and the audit. It is a database file (SQLite) that one
/// thread of one process writes; other processes may open it for reading. Every call that makes a change
/// returns once the change is on the disk, so that a kill or a power cut loses no change whose call has
/// returned.
///
/// A job in the queue is never lost, and an execution is never begun twice: `begin` is refused while an
/// execution has not ended.
class CellJournal {
 public:
  /// Opens the journal, makes it if it is missing, or brings an older one up to date. A damaged one is
  /// renamed with `.damaged` and a number, and a new one is made.
  /// @throws FileError if folder or file cannot be written, or a newer version has written the file
  explicit CellJournal(const std::string& path);

  /// Opens a journal for reading, also while its cell works. Calls that would change it are refused.
  /// @throws FileError if it cannot be read, is damaged, or is not of this version
  static CellJournal read(const std::string& path);
  ~CellJournal();
  CellJournal(CellJournal&&) noexcept;
  CellJournal& operator=(CellJournal&&) noexcept;

  /// Path of the damaged journal that was moved aside on opening; empty if there was none.
  const std::string& movedAside() const { return moved_aside_; }

  /// Adds a job at the end of the queue, not allowed to start.
  std::int64_t addJob(const NewJob& job, double time_s);
  /// All jobs in the queue, in its order: those that have neither ended nor been removed.
  std::vector<QueuedJob> queue() const;
  /// A job, also one that has ended.
  /// @throws InvalidInput if there is no such job
  QueuedJob job(std::int64_t id) const;
  /// The first job in the queue that is allowed to start.
  std::optional<QueuedJob> next() const;

  /// Allows a waiting job to start.
  /// @throws InvalidInput if the job is in another state, naming it
  void release(std::int64_t id, const std::string& by, double time_s);
  /// Withdraws the release of a job that was not begun.
  /// @throws InvalidInput if the job is in another state, naming it
  void revoke(std::int64_t id, const std::string& by, double time_s);
  /// Moves a job to the front of the queue.
  /// @throws InvalidInput if it is not in the queue
  void moveToFront(std::int64_t id, const std::string& by, double time_s);
  /// Moves a job to a place in the queue, counted from 1 in the order of `queue`.
  /// @throws InvalidInput if it is not in the queue, or the queue has no such place
  void moveTo(std::int64_t id, std::int64_t place, const std::string& by, double time_s);
  /// Removes a job from the queue. Its executions stay in the journal.
  /// @throws InvalidInput if it is not in the queue, is running or is interrupted
  void remove(std::int64_t id, const std::string& by, double time_s);

  /// Begins an execution of a job that is allowed to start. An interrupted execution is continued by `goOn`.
  /// @return number of the execution
  /// @throws InvalidInput if the job is in another state, or an execution has not ended
  std::int64_t begin(std::int64_t job, const std::string& by, double time_s);
  void setProgress(std::int64_t execution, const ExecutionProgress& progress, double time_s);
  /// Interrupts an execution: its job is held, suspended or cut off.
  void interrupt(std::int64_t execution, const std::string& reason, double time_s);
  /// Continues an interrupted execution.
  void goOn(std::int64_t execution, double time_s);
  /// Ends an execution.
  /// @param outcome  Ended or Aborted
  void end(std::int64_t execution, JobState outcome, const std::string& reason, double time_s);
  /// The execution that has not ended; nothing if there is none.
  std::optional<OpenExecution> open() const;

  void add(const TransitionRow& row);
  void add(const AlarmRow& row);
  /// Acknowledges all rows of an alarm that are not acknowledged yet.
  void acknowledgeAlarm(int alarm, const std::string& by, double time_s);
  /// Marks all rows of an alarm as gone.
  void endAlarm(int alarm, double time_s);
  /// The newest row of an alarm that is not acknowledged or not gone; nothing if all rows are both.
  std::optional<AlarmRow> unsettled(int alarm) const;
  std::vector<TransitionRow> transitions(std::size_t most) const;  ///< the last `most`, oldest first
  std::vector<AlarmRow> alarms(std::size_t most) const;            ///< the last `most`, oldest first

  /// Numbers by name that outlive the process: counters and settings of the unit.
  void setCounters(const std::map<std::string, double>& counters);
  std::map<std::string, double> counters() const;

  /// Adds a row to the audit. Each row holds a digest of itself and of the row before.
  void add(const AuditRow& row);
  /// The first row of the audit whose digest is wrong, counted from 1; nothing if the chain is intact.
  std::optional<std::int64_t> firstBadAudit() const;

  /// Calls `changes` and makes either all changes of the calls within it, or none of them.
  void together(const std::function<void()>& changes);

  /// Copies the whole journal as it is now to another path.
  void backUp(const std::string& path) const;

 private:
  friend class ExecutionLog;
  struct Store;
  CellJournal();

  std::string moved_aside_;
  std::unique_ptr<Store> store_;
};

}  // namespace lamina
