// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/production_cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/journal/part_record.hpp"

namespace lamina {
namespace {

constexpr int kStuckState = 1010;
constexpr int kEmergencyStop = 1207;
constexpr int kJournalDamaged = 7001;
constexpr int kJournalNotWritable = 7003;
constexpr char kPartOnPlate[] = "part_on_plate";
constexpr char kLostMotionsOf[] = "lost_motions_of";  // an execution
constexpr char kMotionsAreLost[] =
    "the machine was stopped with the job, and has lost motions that it had accepted; discard the job, and "
    "print its rest as a program of lamina resume";
constexpr double kProgressInterval = 0.1;   // [s] between two commits
constexpr double kCountersInterval = 10.0;  // [s]
constexpr double kRetryInterval = 1.0;      // [s] of a journal that could not be written
constexpr double kPauseInterval = 0.5;      // [s] between two orders to an executor that has not heard

/// After these the machine may still hold what it had: the job is offered to be gone on with. What would have
/// been held or suspended is stopped only where the executor cannot pause yet.
bool isResumable(int alarm) {
  if (alarm == 0) return false;
  const AlarmCategory category = alarmKind(alarm).category;
  if (category == AlarmCategory::Hold || category == AlarmCategory::Suspend) return true;
  return alarm == kStuckState || alarm == kEmergencyStop || alarm == 2202 || alarm == 2203 || alarm == 2204 ||
         alarm == 3101 || alarm == 3105;
}

UnitState adoptedState(ExecutorPhase phase) {
  switch (phase) {
    case ExecutorPhase::Starting:
      return UnitState::Starting;
    case ExecutorPhase::Pausing:
      return UnitState::Holding;
    case ExecutorPhase::Paused:
      return UnitState::Held;
    case ExecutorPhase::Resuming:
      return UnitState::Unholding;
    case ExecutorPhase::Stopping:
      return UnitState::Stopping;
    default:
      return UnitState::Execute;
  }
}

const Artefact* programArtefact(const QueuedJob& job) {
  const auto found = std::find_if(job.artefacts.begin(), job.artefacts.end(),
                                  [](const Artefact& artefact) { return artefact.kind == "program"; });
  return found == job.artefacts.end() ? nullptr : &*found;
}

/// True if the executor still runs, or has just done, the job that the journal has open.
bool isStillRun(const CellJournal& journal, const ArtefactStore& artefacts,
                const std::optional<ExecutorReport>& seen) {
  const auto open = journal.open();
  if (!open || !seen || seen->phase == ExecutorPhase::Resting) return false;
  // What is done may be an earlier job of the same program, unless this one has had lines.
  if (seen->phase == ExecutorPhase::Done && open->progress.taken_through == 0) return false;
  const QueuedJob job = journal.job(open->job);
  const Artefact* program = programArtefact(job);
  return program != nullptr && artefacts.pathOf(*program) == seen->program;
}

UnitState firstState(const CellJournal& journal, const ArtefactStore& artefacts,
                     const std::optional<ExecutorReport>& seen) {
  if (isStillRun(journal, artefacts, seen)) return adoptedState(seen->phase);
  return journal.open() || !journal.movedAside().empty() ? UnitState::Aborted : UnitState::Stopped;
}

/// Of all executions of all journals: a journal that was begun anew counts from 1 again.
std::string nameOf(const OpenExecution& execution) {
  return std::to_string(execution.id) + '@' + std::to_string(execution.started_s);
}

/// What the executor did last may never have been reported here.
ExecutionStart resumption(const OpenExecution& execution) {
  return execution.progress.taken_through > 0 ? ExecutionStart::Resume : ExecutionStart::ResumeIfBegun;
}

bool isActive(const ActiveAlarms& alarms, int id) {
  return std::any_of(alarms.all().begin(), alarms.all().end(),
                     [id](const ActiveAlarm& alarm) { return alarm.id == id; });
}

/// Why a change ends a job: the alarm that stopped the unit first, and what ended the job if that is another.
std::string endReason(const UnitChange& change, const std::optional<ActiveAlarm>& first) {
  std::string last = change.reason;
  if (last.empty() && change.command) last = std::string(toString(*change.command)) + " by " + change.source;
  // What a person has held is not ended for that.
  if (!first || first->category < AlarmCategory::Suspend || first->id == change.alarm) return last;
  return sentenceOf(*first) + "; then " + last;
}

TransitionRow rowOf(const UnitChange& change, double utc_s) {
  return {utc_s,
          change.mode,
          static_cast<int>(change.from),
          static_cast<int>(change.to),
          change.command ? static_cast<int>(*change.command) : 0,
          change.source,
          change.reason};
}

}  // namespace

ProductionCell::ProductionCell(const UnitSettings& settings, const CellParts& parts,
                               const std::optional<ExecutorReport>& seen, CellTime now)
    : journal_(parts.journal),
      artefacts_(parts.artefacts),
      executor_(parts.executor),
      corrections_(parts.corrections),
      unit_(settings, firstState(journal_, artefacts_, seen), countersOf(journal_.counters(), settings.modes),
            now.steady_s) {
  if (const auto cut_off = journal_.open()) execution_ = cut_off->id;
  is_running_ = isStillRun(journal_, artefacts_, seen);
  const auto counters = journal_.counters();
  const auto on_plate = counters.find(kPartOnPlate);
  is_part_on_plate_ = on_plate != counters.end() && on_plate->second > 0.0;
  const auto lost = counters.find(kLostMotionsOf);
  if (lost != counters.end()) lost_motions_of_ = static_cast<std::int64_t>(lost->second);
  const auto open = journal_.open();
  if (is_running_) {
    report_ = *seen;
    // A job that is resumed reports nothing yet while it is planned and approached: what was laid stays laid.
    report_.progress = furthest(open->progress, seen->progress);
  } else if (seen) {
    bystander_ = seen->phase;
  }
  if (open && !is_running_ && open->progress.taken_through > 0) is_part_on_plate_ = true;
  restoreAlarms(now);
  if (journal_.movedAside().empty()) return;
  // What lies on the plate stood in the journal that is lost.
  is_part_on_plate_ = true;
  raise(kJournalDamaged, 0.0, "moved to " + journal_.movedAside() + "; a new journal has begun", now);
}

/// Alarms that nobody has acknowledged, or whose cause nobody has seen gone, when the process died.
void ProductionCell::restoreAlarms(CellTime now) {
  std::vector<AlarmRow> rows;
  for (const AlarmKind& kind : alarmTable()) {
    if (kind.category < AlarmCategory::Hold) continue;
    if (auto row = journal_.unsettled(kind.id)) rows.push_back(std::move(*row));
  }
  std::sort(rows.begin(), rows.end(),
            [](const AlarmRow& one, const AlarmRow& other) { return one.time_s < other.time_s; });
  for (const AlarmRow& row : rows) {
    const double age_s = std::max(0.0, now.utc_s - row.time_s);
    unit_.restore(row.alarm, row.value, row.message, now.steady_s - age_s, now.steady_s);
    // Who died before its reaction leaves it to this process; what was of another job stops none.
    if (is_running_ && row.execution == execution_) unit_.reactTo(row.alarm, now.steady_s);
  }
}

std::optional<QueuedJob> ProductionCell::currentJob() const {
  const auto open = journal_.open();
  if (!open) return std::nullopt;
  return journal_.job(open->job);
}

std::optional<std::int64_t> ProductionCell::runningExecution() const {
  return is_running_ ? execution_ : std::nullopt;
}

CommandAnswer ProductionCell::command(UnitRequest request, const CellSurroundings& found, CutOffJob cut_off,
                                      CellTime now) {
  try {
    for (UnmetGuard& guard : unmet(request, found, cut_off)) request.unmet.push_back(std::move(guard));
  } catch (const Error& error) {
    request.unmet.push_back(
        {kJournalNotWritable, std::string("the journal cannot be read: ") + error.what()});
  }
  const CutOffJob before = std::exchange(cut_off_, cut_off);
  const std::string operator_before = std::exchange(operator_, request.source);
  CommandAnswer answer = unit_.command(request, now.steady_s);
  if (answer.result != CommandResult::Accepted) {
    cut_off_ = before;
    operator_ = operator_before;
  }
  if (precedence(request.command) <= precedence(UnitCommand::Stop)) settle(now);
  if (const auto row = audit_.rowOf(request, answer, now)) write(now, [&] { journal_.add(*row); });
  settle(now);
  return answer;
}

std::vector<UnmetGuard> ProductionCell::unmet(const UnitRequest& request, const CellSurroundings& found,
                                              CutOffJob cut_off) const {
  if (request.command == UnitCommand::Unhold || request.command == UnitCommand::Unsuspend)
    return againstContinuing(found.go_on);
  if (request.command == UnitCommand::Complete && report_.phase != ExecutorPhase::Done)
    return {{1309, "the executor cannot end a job before its last layer; Stop ends it at once"}};
  // Files are read whole to be compared: not for a command that its state or sequence refuses anyway.
  const UnitStatus& unit = unit_.status();
  if (request.command != UnitCommand::Start || unit.state != UnitState::Idle ||
      request.expected_sequence.value_or(unit.sequence) != unit.sequence)
    return {};
  return againstBeginning(found, cut_off, FileCheck::Whole);
}

std::vector<UnmetGuard> ProductionCell::againstNext(const CellSurroundings& found) const {
  return againstBeginning(found, CutOffJob::Undecided, FileCheck::None);
}

std::vector<UnmetGuard> ProductionCell::againstResuming() const {
  std::vector<UnmetGuard> against;
  const auto open = resumeWaits() ? journal_.open() : std::nullopt;
  if (!open) return against;
  if (open->progress.taken_through > 0 && !is_part_on_plate_)
    against.push_back({1311, "the part that was cut off was taken away; discard its job"});
  if (execution_ == lost_motions_of_) against.push_back({1313, kMotionsAreLost});
  std::string why = executor_.traits().against_resuming;
  if (!why.empty()) against.push_back({1314, std::move(why)});
  return against;
}

std::vector<UnmetGuard> ProductionCell::againstBeginning(const CellSurroundings& found, CutOffJob cut_off,
                                                         FileCheck files) const {
  StartConditions conditions = found.start;
  conditions.mode = unit_.status().mode;
  conditions.is_part_removed = conditions.is_part_removed && !is_part_on_plate_;
  std::vector<UnmetGuard> against;
  if (isAtWork()) against.push_back({1310, "the executor is at work on something else"});
  auto job = journal_.next();
  const auto interrupted = currentJob();
  if (!interrupted && cut_off == CutOffJob::Resume)
    against.push_back({1308, "no job was cut off; there is nothing to resume"});
  if (interrupted) {
    if (cut_off == CutOffJob::Undecided)
      against.push_back({1308, "job " + std::to_string(interrupted->id) + " was cut off after " +
                                   executor_.traits().unit + ' ' +
                                   std::to_string(journal_.open()->progress.taken_through) +
                                   "; say whether it is resumed or discarded"});
    if (cut_off != CutOffJob::Discard) job = interrupted;
    if (cut_off == CutOffJob::Resume) {
      for (UnmetGuard& guard : againstResuming()) against.push_back(std::move(guard));
      conditions.is_part_removed = true;
    }
  }
  conditions.job = job ? job->name : "";
  if (job) conditions.machine_differences = machineDifferences(*job, conditions.machine, artefacts_);
  if (job && files == FileCheck::Whole) conditions.torn = artefacts_.torn(job->artefacts);
  for (UnmetGuard& guard : againstStart(conditions)) against.push_back(std::move(guard));
  return against;
}

CommandAnswer ProductionCell::changeMode(int mode, const std::string& source, CellTime now) {
  CommandAnswer answer = unit_.changeMode(mode, source, now.steady_s);
  settle(now);
  return answer;
}

CommandAnswer ProductionCell::acknowledge(int alarm, const std::string& by, CellTime now) {
  CommandAnswer answer = unit_.acknowledge(alarm, by, now.steady_s);
  write(now, [&] {
    if (answer.result == CommandResult::Accepted) {
      journal_.acknowledgeAlarm(alarm, by, now.utc_s);
      if (!isActive(unit_.status().alarms, alarm)) journal_.endAlarm(alarm, now.utc_s);  // of an earlier run
    }
    journal_.add(AuditRow{now.utc_s, by, "", "acknowledge " + std::to_string(alarm),
                          answer.reason.empty() ? "accepted" : answer.reason});
  });
  return answer;
}

void ProductionCell::raise(int alarm, double value, const std::string& message, CellTime now) {
  const AlarmKind& kind = alarmKind(alarm);
  // Whoever found it, it ends by what this cell writes: a second after it was found last.
  if (alarm == kJournalNotWritable) {
    is_journal_failing_ = true;
    counters_written_s_ = now.steady_s;
  }
  const bool is_to_be_reported = unit_.raise(alarm, value, message, now.steady_s);
  if (kind.category >= AlarmCategory::Stop) settle(now);
  if (is_to_be_reported)
    write(now, [&] {
      keepAlarm({kind.id, kind.category, value, message, now.steady_s, {}, {}, {}, 1}, now.utc_s);
    });
  settle(now);
}

void ProductionCell::keepAlarm(const ActiveAlarm& alarm, double utc_s) {
  const double kept = std::isfinite(alarm.value) ? alarm.value : 0.0;  // the journal takes numbers alone
  journal_.together([&] {
    journal_.add(AlarmRow{utc_s, alarm.id, kept, letterOf(alarm.category), alarm.message});
    if (alarmKind(alarm.id).cause == AlarmCause::Event) journal_.endAlarm(alarm.id, utc_s);
  });
}

void ProductionCell::end(int alarm, CellTime now) {
  unit_.end(alarm, now.steady_s);
  write(now, [&] { journal_.endAlarm(alarm, now.utc_s); });
}

void ProductionCell::onReport(const ExecutorReport& report, CellTime now) {
  const bool is_ours = report.order == order_ && (order_ != 0 || is_running_);
  if (report.order == 0 && !is_ours) bystander_ = report.phase;
  if (!is_ours) return tick(now);
  bystander_ = ExecutorPhase::Resting;
  const bool has_ended = is_running_ && isAtRest(report.phase);
  const ExecutionProgress before = report_.progress;
  report_ = report;
  report_.progress = furthest(before, report_.progress);
  has_run_ = has_run_ || report.phase == ExecutorPhase::Running;
  const bool is_due = report.progress.layer != layer_written_ || has_ended ||
                      now.steady_s - progress_written_s_ >= kProgressInterval;
  if (execution_ && is_running_ && is_due) {
    progress_written_s_ = now.steady_s;
    layer_written_ = report.progress.layer;
    write(now, [&] { journal_.setProgress(*execution_, report_.progress, now.utc_s); });
  }
  if (has_ended && report.phase == ExecutorPhase::Resting) onEnd(now);
  tick(now);
}

/// The executor is at rest before the job is done: nobody here has asked it to, or the unit is stopping.
void ProductionCell::onEnd(CellTime now) {
  const UnitState state = unit_.status().state;
  if (state == UnitState::Stopping || state == UnitState::Aborting) return;
  // Nobody here has ended it, and what has not run can be begun again: the job is not given up.
  is_given_up_ = has_run_ && report_.alarm != 0 && !isResumable(report_.alarm);
  if (report_.alarm != 0) return raise(report_.alarm, 0.0, report_.failure, now);
  unit_.command({UnitCommand::Stop, "executor", {}, {}}, now.steady_s);
  settle(now);
}

/// An order to pause that came before the job did was refused; and a machine whose button somebody presses
/// may go on where the unit may not.
void ProductionCell::pauseAgain(CellTime now) {
  const UnitState state = unit_.status().state;
  const bool is_due = state == UnitState::Holding || state == UnitState::Suspending ||
                      state == UnitState::Held || state == UnitState::Suspended;
  const bool is_heard = report_.phase != ExecutorPhase::Starting && report_.phase != ExecutorPhase::Running;
  if (!is_due || is_heard || now.steady_s - paused_s_ < kPauseInterval) return;
  paused_s_ = now.steady_s;
  executor_.pause();
}

/// An executor may pause and go on by itself, as a machine does that waits for a person.
void ProductionCell::followPause(CellTime now) {
  const UnitState state = unit_.status().state;
  if (state == UnitState::Execute) is_held_by_executor_ = report_.phase == ExecutorPhase::Paused;
  if (!is_held_by_executor_) return;
  if (state == UnitState::Execute) unit_.command({UnitCommand::Hold, "executor", {}, {}}, now.steady_s);
  if (state != UnitState::Held || report_.phase != ExecutorPhase::Running) return;
  const CommandAnswer answer = unit_.command({UnitCommand::Unhold, "executor", {}, {}}, now.steady_s);
  // From here on it is held by the unit, and goes on when somebody orders that.
  if (answer.result != CommandResult::Accepted) is_held_by_executor_ = false;
}

void ProductionCell::tick(CellTime now) {
  unit_.tick(now.steady_s);
  for (const ActiveAlarm& alarm : unit_.takeReturned(now.steady_s))
    write(now, [&] { keepAlarm(alarm, now.utc_s - (now.steady_s - alarm.raised_s)); });
  followPause(now);
  pauseAgain(now);
  settle(now);
  while (isComplete()) {
    const std::uint32_t before = unit_.status().sequence;
    unit_.complete(unit_.status().state, now.steady_s);
    settle(now);
    if (unit_.status().sequence == before) break;
  }
  if (unit_.status().state == UnitState::Completing && execution_ &&
      now.steady_s - end_tried_s_ >= kRetryInterval) {
    end_tried_s_ = now.steady_s;
    close(JobState::Ended, "", now);
  }
  const double interval_s = is_journal_failing_ ? kRetryInterval : kCountersInterval;
  if (now.steady_s - counters_written_s_ < interval_s) return;
  counters_written_s_ = now.steady_s;
  write(now, [&] {
    keepCounters();
    keepLastRecord(now);
    if (!is_journal_failing_) return;
    journal_.endAlarm(kJournalNotWritable, now.utc_s);
    unit_.end(kJournalNotWritable, now.steady_s);
    is_journal_failing_ = false;
  });
}

bool ProductionCell::isComplete() const {
  const ExecutorPhase phase = report_.phase;
  switch (unit_.status().state) {
    case UnitState::Clearing:
    case UnitState::Resetting:
    case UnitState::Stopping:
    case UnitState::Aborting:
      return !isAtWork();
    case UnitState::Starting:
    case UnitState::Unholding:
    case UnitState::Unsuspending:
      return phase == ExecutorPhase::Running || phase == ExecutorPhase::Done;
    case UnitState::Holding:
    case UnitState::Suspending:
      return phase == ExecutorPhase::Paused || phase == ExecutorPhase::Done;
    case UnitState::Execute:
      return phase == ExecutorPhase::Done;
    case UnitState::Completing:
      return !execution_;  // its end is in the journal
    default:
      return false;
  }
}

void ProductionCell::settle(CellTime now) {
  // Acting on a change may raise an alarm, which is a change again; no chain of them is longer than the
  // states.
  for (std::size_t round = 0; round < unitStates().size(); ++round) {
    const std::vector<UnitChange> changes = unit_.takeChanges();
    if (changes.empty()) return;
    std::vector<ActiveAlarm> own = unit_.takeAlarms();
    for (const UnitChange& change : changes) follow(change, std::exchange(own, {}), now);
  }
}

void ProductionCell::follow(const UnitChange& change, const std::vector<ActiveAlarm>& own, CellTime now) {
  const bool acts_first = change.to == UnitState::Stopping || change.to == UnitState::Aborting;
  // Whatever ends a job gives it up, but for an end that came by itself (`onEnd`) or by what can be mended.
  if (acts_first && !isAtRest(report_.phase)) is_given_up_ = !isResumable(change.alarm);
  if (acts_first) end_reason_ = endReason(change, unit_.status().stop_reason);
  if (acts_first) act(change, now);
  // One wait for the disk.
  write(now, [&] {
    journal_.together([&] {
      journal_.add(rowOf(change, now.utc_s));
      // Before the end of an execution that it leads to: later it would belong to none.
      for (const ActiveAlarm& alarm : own) keepAlarm(alarm, now.utc_s);
    });
  });
  if (!acts_first && unit_.status().sequence == change.sequence) act(change, now);
}

void ProductionCell::act(const UnitChange& change, CellTime now) {
  if (change.from == change.to) return;
  switch (change.to) {
    case UnitState::Starting:
      return begin(now);
    case UnitState::Holding:
    case UnitState::Suspending:
      paused_s_ = now.steady_s;
      return executor_.pause();
    case UnitState::Unholding:
    case UnitState::Unsuspending:
      return executor_.resume();
    case UnitState::Clearing:
      if (isAtWork()) executor_.abort();
      return;
    case UnitState::Stopping:
      if (isAtWork()) executor_.stop();
      return;
    case UnitState::Aborting:
      if (isAtWork()) executor_.abort();
      return;
    case UnitState::Held:
    case UnitState::Suspended:
      return interrupt(now);
    case UnitState::Execute:
      if (change.from == UnitState::Starting) return;
      return write(now, [&] {
        if (execution_) journal_.goOn(*execution_, now.utc_s);
      });
    case UnitState::Completing:
      unit_.countPart(PartVerdict::Good, report_.progress.deposited_mm3);
      is_part_on_plate_ = true;
      end_tried_s_ = now.steady_s;
      return close(JobState::Ended, "", now);
    case UnitState::Stopped:
    case UnitState::Aborted:
      // The end of Stopping or Aborting has a reason of its own only where nobody has confirmed it.
      if (is_running_)
        close(JobState::Aborted, end_reason_ + (change.reason.empty() ? "" : "; " + change.reason), now);
      return;
    default:
      return;
  }
}

void ProductionCell::begin(CellTime now) {
  report_ = {};
  has_run_ = false;
  is_given_up_ = false;
  write(now, [&] {
    if (execution_ && cut_off_ == CutOffJob::Discard)
      writeEnd(JobState::Aborted, "discarded by " + operator_, now);
    const auto cut_off = journal_.open();
    const auto job = cut_off ? journal_.job(cut_off->job) : nextJob();
    const std::string program = programOf(job);
    if (cut_off)
      journal_.goOn(cut_off->id, now.utc_s);
    else
      execution_ = journal_.begin(job.id, operator_, now.utc_s);
    is_running_ = true;
    report_.phase = ExecutorPhase::Starting;
    layer_written_ = -1;
    const auto open = journal_.open();
    // What was laid stays laid, whatever is reported on the way there.
    report_.progress = open->progress;
    executor_.start({program, cut_off ? resumption(*open) : ExecutionStart::Anew, ++order_, nameOf(*open),
                     open->progress});
  });
}

QueuedJob ProductionCell::nextJob() const {
  auto next = journal_.next();
  if (!next) throw InvalidInput("no job of the queue is allowed to start");
  return std::move(*next);
}

bool ProductionCell::isAtWork() const { return !isAtRest(report_.phase) || !isAtRest(bystander_); }

void ProductionCell::interrupt(CellTime now) {
  const auto& reason = unit_.status().stop_reason;
  write(now, [&] {
    if (execution_) journal_.interrupt(*execution_, reason ? sentenceOf(*reason) : "", now.utc_s);
  });
}

void ProductionCell::close(JobState outcome, const std::string& reason, CellTime now) {
  if (!execution_) return;
  const bool is_cut_off = outcome == JobState::Aborted && is_running_ && !is_given_up_;
  is_running_ = false;
  if (report_.progress.taken_through > 0) is_part_on_plate_ = true;
  if (is_cut_off && report_.has_lost_motions) lost_motions_of_ = *execution_;
  write(now, [&] {
    if (!is_cut_off) return writeEnd(outcome, reason, now);
    journal_.together([&] {
      journal_.setProgress(*execution_, report_.progress, now.utc_s);  // what came since it was last due
      journal_.interrupt(*execution_, reason, now.utc_s);
      keepCounters();
    });
  });
}

/// @throws Error if the journal cannot be written: the execution then has no end
void ProductionCell::writeEnd(JobState outcome, const std::string& reason, CellTime now) {
  // A kill between the two would count a part twice, or forget that it lies on the plate.
  journal_.together([&] {
    journal_.end(*execution_, outcome, reason, now.utc_s);
    keepCounters();
  });
  execution_.reset();
  write(now, [&] { keepLastRecord(now); });
}

std::string ProductionCell::programOf(const QueuedJob& job) const {
  const Artefact* program = programArtefact(job);
  if (program == nullptr) throw InvalidInput("job " + std::to_string(job.id) + " has no program");
  return artefacts_.pathOf(*program);
}

void ProductionCell::keepCounters() {
  auto named = namedCounters(unit_.status().counters);
  named[kPartOnPlate] = is_part_on_plate_ ? 1.0 : 0.0;
  named[kLostMotionsOf] = static_cast<double>(lost_motions_of_);
  journal_.setCounters(named);
}

/// What could not be written when the job ended is written once it can be.
void ProductionCell::keepLastRecord(CellTime now) {
  const auto ended = ExecutionLog(journal_).lastWithoutPart();
  if (!ended) return;
  const char* verdict = ended->outcome == JobState::Ended ? "good" : "aborted";
  PartOutcome end{verdict, now.utc_s, {}};
  if (corrections_) end.corrections = corrections_(journal_.job(ended->job), *ended);
  keepRecord(journal_, artefacts_, ended->id, end);
}

void ProductionCell::write(CellTime now, const std::function<void()>& rows) {
  try {
    rows();
  } catch (const Error& error) {
    // The alarm itself is not written: what could not be written just now would fail again.
    is_journal_failing_ = true;
    unit_.raise(kJournalNotWritable, 0.0, error.what(), now.steady_s);
  }
}

void ProductionCell::confirmRemoval(const std::string& by, CellTime now) {
  if (!std::exchange(is_part_on_plate_, false)) return;
  write(now, [&] {
    journal_.together([&] {
      journal_.add(AuditRow{now.utc_s, by, "", "part removed", "confirmed"});
      ExecutionLog(journal_).removePart(by, now.utc_s);
      keepCounters();
    });
  });
}

}  // namespace lamina
