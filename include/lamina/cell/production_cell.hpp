// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/cell_time.hpp"
#include "lamina/cell/guards.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// What an executor does.
enum class ExecutorPhase : std::uint8_t {
  Resting,  ///< no job, or one that was stopped or aborted; at rest
  Starting,
  Running,
  Pausing,
  Paused,
  Resuming,
  Stopping,
  Done,  ///< the job has run to its end
};

/// Whether no job is under way.
inline bool isAtRest(ExecutorPhase phase) {
  return phase == ExecutorPhase::Resting || phase == ExecutorPhase::Done;
}

/// How a job is begun by an executor.
enum class ExecutionStart : std::uint8_t {
  Anew,
  Resume,         ///< lines of it were taken by the machine: it is gone on with, or refused
  ResumeIfBegun,  ///< nobody here knows whether a line of it has left: if none has, it is begun
};

/// A job as an executor is given it.
struct StartOrder {
  std::string program;
  ExecutionStart start = ExecutionStart::Anew;
  std::uint64_t order = 0;  ///< number that its reports name, from 1; 0 in a report: not ordered here
  std::string execution;    ///< names this execution of the job, in this journal and in every other
};

/// What an executor last said.
struct ExecutorReport {
  ExecutorPhase phase = ExecutorPhase::Resting;
  std::uint64_t order = 0;  ///< the start that it speaks of; 0 for a job that was there before
  std::string program;      ///< path of the job's program
  std::uint64_t lines = 0;
  ExecutionProgress progress;
  int alarm = 0;        ///< ID of the alarm that ended the job; 0 if none did, or it has not ended
  std::string failure;  ///< the same in a sentence
};

/// Moves the machine by orders of the cell. Orders return at once; reports show what became of them.
class Executor {
 public:
  virtual ~Executor() = default;
  /// An execution that is complete by the executor's own record is reported as done.
  virtual void start(const StartOrder& order) = 0;
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// Ends the job: controlled, and the machine is left as its settings say.
  virtual void stop() = 0;
  /// Ends the job as fast as the executor can.
  virtual void abort() = 0;
};

/// What Start is to do with a job that was cut off.
enum class CutOffJob : std::uint8_t { Undecided, Resume, Discard };

/// What only the surroundings know of the guards; the run itself fills in job, files, mode and journal.
struct CellSurroundings {
  StartConditions start;
  ContinueConditions go_on;
};

/// What a cell works with; all of it outlives the cell.
struct CellParts {
  CellJournal& journal;
  ArtefactStore& artefacts;
  Executor& executor;
  /// Keeps, and names, the maps that an execution was corrected by; may be empty.
  std::function<std::vector<Artefact>(const QueuedJob&, const ExecutionRow&)> corrections = {};
};

/// A cell at work: the unit, its journal and one executor. Commands, reports and times come in; orders to the
/// executor, rows of the journal and the unit's status come out.
///
/// A change is written into the journal before it is acted upon, but commands that stop are acted upon first.
/// A journal that cannot be written raises 7003; a job that is done stays in Completing until its end is
/// written. After a restart, a job that the executor still runs is adopted; one that was cut off waits in
/// Aborted for Clear, Reset, and a Start that says what to do with it.
class ProductionCell {
 public:
  /// @param seen  what the executor says just now; nothing if it does not answer
  ProductionCell(const UnitSettings& settings, const CellParts& parts,
                 const std::optional<ExecutorReport>& seen, CellTime now);

  const UnitStatus& status() const { return unit_.status(); }
  const ExecutorReport& report() const { return report_; }
  /// The job that runs or was cut off; nothing if there is none.
  std::optional<QueuedJob> currentJob() const;
  /// The execution that the executor is at work on; nothing if there is none.
  std::optional<std::int64_t> runningExecution() const;
  /// True if a job was cut off, and nobody has said what becomes of it.
  bool resumeWaits() const { return execution_ && !is_running_; }

  CommandAnswer command(UnitRequest request, const CellSurroundings& found, CutOffJob cut_off, CellTime now);
  CommandAnswer changeMode(int mode, const std::string& source, CellTime now);
  CommandAnswer acknowledge(int alarm, const std::string& by, CellTime now);

  void raise(int alarm, double value, const std::string& message, CellTime now);
  void end(int alarm, CellTime now);

  void onReport(const ExecutorReport& report, CellTime now);

  /// Lets time pass. Call it ten times a second or more often.
  void tick(CellTime now);

  /// The last part was taken away.
  void confirmRemoval(const std::string& by, CellTime now);
  bool isPartOnPlate() const { return is_part_on_plate_; }

 private:
  /// A command that was refused, with those like it that are in no row.
  struct Refusal {
    std::string who;
    std::string action;
    double written_s = 0.0;
    std::size_t unwritten = 0;
  };
  std::vector<UnmetGuard> unmet(const UnitRequest& request, const CellSurroundings& found,
                                CutOffJob cut_off) const;
  void settle(CellTime now);
  void pauseAgain(CellTime now);
  bool isComplete() const;
  bool isAtWork() const;
  QueuedJob nextJob() const;
  void onEnd(CellTime now);
  std::string programOf(const QueuedJob& job) const;
  void act(const UnitChange& change, CellTime now);
  void begin(CellTime now);
  void interrupt(CellTime now);
  void close(JobState outcome, const std::string& reason, CellTime now);
  void writeEnd(JobState outcome, const std::string& reason, CellTime now);
  void keepCommand(const UnitRequest& request, const CommandAnswer& answer, CellTime now);
  void keepCounters();
  void keepLastRecord(CellTime now);
  void write(CellTime now, const std::function<void()>& rows);

  CellJournal& journal_;
  ArtefactStore& artefacts_;
  Executor& executor_;
  std::function<std::vector<Artefact>(const QueuedJob&, const ExecutionRow&)> corrections_;
  UnitMachine unit_;
  ExecutorReport report_;
  std::optional<std::int64_t> execution_;             ///< that has no end yet
  bool is_running_ = false;                           ///< by the executor, in this run of the cell
  std::uint64_t order_ = 0;                           ///< the last start
  ExecutorPhase bystander_ = ExecutorPhase::Resting;  ///< of what the executor runs that is not ours
  bool has_run_ = false;                              ///< since the last start
  bool is_given_up_ = false;                          ///< the job that ends is not offered to be resumed
  bool is_journal_failing_ = false;
  bool is_part_on_plate_ = false;
  CutOffJob cut_off_ = CutOffJob::Undecided;
  std::string operator_;
  double progress_written_s_ = 0.0;
  std::int32_t layer_written_ = -1;
  double counters_written_s_ = 0.0;
  double end_tried_s_ = 0.0;  ///< of a job that is done
  double paused_s_ = 0.0;     ///< when the executor was last asked to
  Refusal refusal_;
};

}  // namespace lamina
