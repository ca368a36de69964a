// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/cell_time.hpp"
#include "lamina/cell/command_audit.hpp"
#include "lamina/cell/executor.hpp"
#include "lamina/cell/guards.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// What Start does with a job that was cut off.
enum class CutOffJob : std::uint8_t { Undecided, Resume, Discard };

/// The conditions of the guards that the caller must determine. `ProductionCell` adds job, files, mode and
/// journal.
struct CellSurroundings {
  StartConditions start;
  ContinueConditions go_on;
};

/// The objects that a cell uses; all of them must outlive the cell.
struct CellParts {
  CellJournal& journal;
  ArtefactStore& artefacts;
  Executor& executor;
  /// Stores the maps by which an execution was corrected and returns them as artefacts; may be empty.
  std::function<std::vector<Artefact>(const QueuedJob&, const ExecutionRow&)> corrections = {};
};

/// A cell at work: the unit, its journal and one executor. Commands, reports and times are passed to it; it
/// gives orders to the executor, writes rows of the journal, and provides the status of the unit.
///
/// A change is written into the journal before it is acted upon, except for commands that stop, which are
/// acted upon first. A journal that cannot be written raises alarm 7003; a job that is done stays in
/// Completing until its end is written. After a restart, a job that the executor still runs is continued
/// under the cell. One that was cut off waits in Aborted for Clear, Reset, and a Start that states what to do
/// with it. Latched alarms of before wait to be acknowledged.
class ProductionCell {
 public:
  /// @param seen  present report of the executor; nothing if it does not answer
  ProductionCell(const UnitSettings& settings, const CellParts& parts,
                 const std::optional<ExecutorReport>& seen, CellTime now);

  const UnitStatus& status() const { return unit_.status(); }
  const ExecutorReport& report() const { return report_; }
  /// The job that runs or was cut off; nothing if there is none.
  std::optional<QueuedJob> currentJob() const;
  /// The execution that the executor is running; nothing if there is none.
  std::optional<std::int64_t> runningExecution() const;
  /// Whether a job that was cut off waits for the decision on resuming it.
  bool resumeWaits() const { return execution_ && !is_running_; }

  /// The reasons for which the job that was cut off cannot be resumed, whatever the unit's state; none if it
  /// can be, or if there is none.
  std::vector<UnmetGuard> againstResuming() const;

  /// The reasons against a start of the next job, without the checks that read its files.
  std::vector<UnmetGuard> againstNext(const CellSurroundings& found) const;

  /// Answers a command and follows it if it is accepted; answer and command are written into the journal.
  /// @param found    conditions of the guards at present
  /// @param cut_off  for Start: what to do with a job that was cut off
  CommandAnswer command(UnitRequest request, const CellSurroundings& found, CutOffJob cut_off, CellTime now);
  CommandAnswer changeMode(int mode, const std::string& source, CellTime now);
  CommandAnswer acknowledge(int alarm, const std::string& by, CellTime now);

  /// Raises an alarm, as `UnitMachine::raise`. A value that is not finite is written into the journal as 0.
  void raise(int alarm, double value, const std::string& message, CellTime now);
  /// States that the cause of an alarm is gone.
  void end(int alarm, CellTime now);

  /// Evaluates a report of the executor.
  void onReport(const ExecutorReport& report, CellTime now);

  /// Advances the time; to be called at least ten times a second.
  void tick(CellTime now);

  /// States that the last part was taken away.
  /// @param by  name of the user
  void confirmRemoval(const std::string& by, CellTime now);
  bool isPartOnPlate() const { return is_part_on_plate_; }

 private:
  enum class FileCheck : std::uint8_t { None, Whole };
  std::vector<UnmetGuard> unmet(const UnitRequest& request, const CellSurroundings& found,
                                CutOffJob cut_off) const;
  std::vector<UnmetGuard> againstBeginning(const CellSurroundings& found, CutOffJob cut_off,
                                           FileCheck files) const;
  void settle(CellTime now);
  void follow(const UnitChange& change, const std::vector<ActiveAlarm>& own, CellTime now);
  void pauseAgain(CellTime now);
  void followPause(CellTime now);
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
  void restoreAlarms(CellTime now);
  void keepAlarm(const ActiveAlarm& alarm, double utc_s);
  void keepCounters();
  void keepLastRecord(CellTime now);
  void write(CellTime now, const std::function<void()>& rows);

  CellJournal& journal_;
  ArtefactStore& artefacts_;
  Executor& executor_;
  std::function<std::vector<Artefact>(const QueuedJob&, const ExecutionRow&)> corrections_;
  UnitMachine unit_;
  ExecutorReport report_;
  std::optional<std::int64_t> execution_;  ///< execution that has no end yet
  bool is_running_ = false;                ///< whether the executor runs it, in this run of the cell
  std::uint64_t order_ = 0;                ///< number of the last order to start
  /// Phase of a job in the executor that is not of this cell.
  ExecutorPhase bystander_ = ExecutorPhase::Resting;
  bool has_run_ = false;              ///< whether the job has run since the last start
  bool is_held_by_executor_ = false;  ///< whether the unit was held last since its executor paused by itself
  bool is_given_up_ = false;          ///< whether the job that ends is not to be offered for resuming
  std::string end_reason_;            ///< why the unit was stopped or aborted last
  bool is_journal_failing_ = false;
  bool is_part_on_plate_ = false;
  CutOffJob cut_off_ = CutOffJob::Undecided;
  std::string operator_;
  /// Execution that was cut off with the loss of motions that the machine had accepted; 0 for none.
  std::int64_t lost_motions_of_ = 0;
  double progress_written_s_ = 0.0;
  std::int32_t layer_written_ = -1;
  double counters_written_s_ = 0.0;
  double end_tried_s_ = 0.0;  ///< time of the last attempt to write the end of a job
  double paused_s_ = 0.0;     ///< time at which the executor was last asked to pause
  CommandAudit audit_;
};

}  // namespace lamina
