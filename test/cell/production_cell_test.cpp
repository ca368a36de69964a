// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/production_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {
namespace {

/// An executor that does what it is told when it is asked to, and prints ten lines a step.
class PrintingExecutor final : public Executor {
 public:
  void start(const StartOrder& order) override {
    const bool is_known = taken.count(order.execution) > 0;
    EXPECT_TRUE(is_known || order.start != ExecutionStart::Resume) << "nothing is there to go on with";
    EXPECT_FALSE(is_known && order.start == ExecutionStart::Anew) << "it would lay lines twice";
    orders.emplace_back(is_known ? "resume job" : "start");
    if (is_known) ++resumed[order.program];
    execution_ = order.execution;
    const std::uint64_t from = is_known ? taken[execution_] : 0;
    report = {ExecutorPhase::Starting, order.order, order.program, 100, {from, from, -1, 0.0, 0.0}, 0, ""};
  }
  void pause() override {
    orders.emplace_back("pause");
    if (isAtWork()) report.phase = ExecutorPhase::Pausing;
  }
  void resume() override {
    orders.emplace_back("resume");
    if (report.phase == ExecutorPhase::Paused) report.phase = ExecutorPhase::Resuming;
  }
  void stop() override {
    orders.emplace_back("stop");
    if (isAtWork()) report.phase = ExecutorPhase::Stopping;
  }
  void abort() override {
    orders.emplace_back("abort");
    if (isAtWork()) report.phase = ExecutorPhase::Stopping;
  }

  void step() {
    switch (report.phase) {
      case ExecutorPhase::Starting:
      case ExecutorPhase::Resuming:
        report.phase = ExecutorPhase::Running;
        break;
      case ExecutorPhase::Pausing:
        report.phase = ExecutorPhase::Paused;
        break;
      case ExecutorPhase::Stopping:
        report.phase = ExecutorPhase::Resting;
        break;
      case ExecutorPhase::Running:
        if (report.progress.taken_through == 0) ++begun[report.program];
        report.progress.taken_through += 10;
        taken[execution_] = report.progress.taken_through;
        report.progress.sent_through = report.progress.taken_through + 5;
        report.progress.laid_mm3 += 5.0;
        if (report.progress.taken_through >= report.lines) report.phase = ExecutorPhase::Done;
        break;
      default:
        break;
    }
  }
  void fail(int alarm, const std::string& failure) {
    report.phase = ExecutorPhase::Resting;
    report.alarm = alarm;
    report.failure = failure;
  }
  bool isAtWork() const {
    return report.phase != ExecutorPhase::Resting && report.phase != ExecutorPhase::Done;
  }

  ExecutorReport report;
  std::vector<std::string> orders;
  std::map<std::string, std::uint64_t> taken;  ///< lines, by execution: what its progress file knows
  std::map<std::string, int> begun;            ///< its first lines were laid
  std::map<std::string, int> resumed;

 private:
  std::string execution_;
};

/// A cell on disk with an executor, whose process can be killed and started again.
class Cell {
 public:
  Cell() { start(); }

  void start() {
    journal_ = std::make_unique<CellJournal>(folder_.path() + "/cell.db");
    artefacts_ = std::make_unique<ArtefactStore>(folder_.path() + "/artefacts");
    // After a restart the executor's reports speak of a job that was there before.
    if (run_once_) executor.report.order = 0;
    const auto seen = run_once_ ? std::optional<ExecutorReport>(executor.report) : std::nullopt;
    run_once_ = true;
    run_ = std::make_unique<ProductionCell>(UnitSettings{}, CellParts{*journal_, *artefacts_, executor}, seen,
                                            now);
  }

  void kill() {
    run_.reset();
    artefacts_.reset();
    journal_.reset();
  }

  std::int64_t enqueue(const std::string& name) {
    std::ofstream(folder_.path() + "/" + name) << "G1 X1 ; " << name;
    const Artefact program = artefacts_->keep(folder_.path() + "/" + name, "program", name);
    const std::int64_t id = journal_->addJob({name, name, "gantry", {program}, "anna"}, now.utc_s);
    journal_->release(id, "anna", now.utc_s);
    return id;
  }

  CommandResult command(UnitCommand command, CutOffJob cut_off = CutOffJob::Undecided) {
    CellSurroundings found;
    found.start.is_checked = true;
    found.start.machine = "gantry";
    found.start.free_bytes = 1e10;
    found.go_on.is_position_known = true;
    answer = run_->command({command, "anna", std::nullopt, {}}, found, cut_off, now);
    return answer.result;
  }

  /// Steps executor and unit until the unit is in that state, at most a thousand times.
  bool reaches(UnitState state) {
    for (int i = 0; i < 1000 && run_->status().state != state; ++i) step();
    return run_->status().state == state;
  }

  void step() {
    now.steady_s += 0.05;
    now.utc_s += 0.05;
    executor.step();
    run_->onReport(executor.report, now);
    run_->tick(now);
  }

  UnitState state() const { return run_->status().state; }
  ProductionCell& run() { return *run_; }
  CellJournal& journal() { return *journal_; }
  const std::string& folder() const { return folder_.path(); }
  bool hasAlarm(int id) const {
    const auto& alarms = run_->status().alarms.all();
    return std::any_of(alarms.begin(), alarms.end(),
                       [id](const ActiveAlarm& alarm) { return alarm.id == id; });
  }

  PrintingExecutor executor;
  CellTime now{100.0, 1.7e9};
  CommandAnswer answer;

 private:
  ScratchFolder folder_;
  bool run_once_ = false;
  std::unique_ptr<CellJournal> journal_;
  std::unique_ptr<ArtefactStore> artefacts_;
  std::unique_ptr<ProductionCell> run_;
};

void bringToIdle(Cell& cell) {
  ASSERT_EQ(cell.command(UnitCommand::Reset), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Idle));
}

TEST(ProductionCell, PrintsAJobFromTheQueue) {
  Cell cell;
  EXPECT_EQ(cell.state(), UnitState::Stopped);
  bringToIdle(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("no job of the queue"), std::string::npos);
  const std::int64_t job = cell.enqueue("bracket.gcode");
  ASSERT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Running);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
  EXPECT_EQ(cell.run().status().counters.parts, 1U);
  EXPECT_DOUBLE_EQ(cell.run().status().counters.material_mm3, 50.0);
}

TEST(ProductionCell, KeepsTheRecordOfAPart) {
  Cell cell;
  const std::int64_t job = cell.enqueue("bracket");
  bringToIdle(cell);
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  ExecutionLog log(cell.journal());
  const auto part = log.part(log.ofJob(job)->id);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->verdict, "good");
  EXPECT_FALSE(part->removed_s);
  EXPECT_GE(log.transitions(log.ofJob(job)->id).size(), 3U) << "Starting, Execute, Completing";
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_EQ(log.part(log.ofJob(job)->id)->removed_by, "anna");
  EXPECT_FALSE(log.lastWithoutPart());
}

TEST(ProductionCell, KeepsTheRecordOfAnAbortedPartWhenItCanBeWrittenAgain) {
  Cell cell;
  const std::int64_t job = cell.enqueue("bracket");
  bringToIdle(cell);
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  const std::string artefacts = cell.folder() + "/artefacts";
  std::filesystem::rename(artefacts, artefacts + "_away");
  cell.command(UnitCommand::Stop);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  ExecutionLog log(cell.journal());
  EXPECT_FALSE(log.part(log.ofJob(job)->id));
  EXPECT_TRUE(cell.hasAlarm(7003));
  std::filesystem::rename(artefacts + "_away", artefacts);
  for (int i = 0; i < 40 && !log.part(log.ofJob(job)->id); ++i) cell.step();
  ASSERT_TRUE(log.part(log.ofJob(job)->id));
  EXPECT_EQ(log.part(log.ofJob(job)->id)->verdict, "aborted");
}

TEST(ProductionCell, StartsNothingBesideAPartThatWasNotRemoved) {
  Cell cell;
  bringToIdle(cell);
  cell.enqueue("a.gcode");
  cell.enqueue("b.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  cell.kill();
  cell.start();
  bringToIdle(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed) << "remembered over a restart";
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted);
}

TEST(ProductionCell, HoldsAndGoesOn) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  EXPECT_EQ(cell.command(UnitCommand::Hold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "pause", "resume"}));
}

TEST(ProductionCell, EndsTheJobItStops) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.command(UnitCommand::Stop);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_FALSE(cell.journal().open());
}

TEST(ProductionCell, AbortsWhenTheMachineFails) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.executor.fail(3104, "thermistor of the nozzle reads 400 degC; expected at most 300");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.run().status().stop_reason->id, 3104);
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_EQ(cell.journal().alarms(10).back().alarm, 3104);
  EXPECT_EQ(cell.command(UnitCommand::Clear), CommandResult::GuardFailed);
  cell.run().acknowledge(3104, "anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Clear), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
}

TEST(ProductionCell, OffersToGoOnAfterALostLink) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.step();
  cell.executor.fail(3101, "the port is gone");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  cell.run().acknowledge(3101, "anna", cell.now);
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  EXPECT_TRUE(cell.run().resumeWaits());
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed) << "never by itself";
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "resume job"}));
}

TEST(ProductionCell, DiscardsACutOffJobAndPrintsTheNext) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t first = cell.enqueue("a.gcode");
  const std::int64_t second = cell.enqueue("b.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  for (int i = 0; i < 4; ++i) cell.step();
  cell.kill();
  cell.executor.fail(0, "");
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Aborted);
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Discard), CommandResult::GuardFailed)
      << "its part is there";
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::GuardFailed)
      << "and now it is not";
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Discard), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(first).state, JobState::Aborted);
  EXPECT_EQ(cell.journal().job(second).state, JobState::Ended);
}

TEST(ProductionCell, AdoptsAJobThatRunsOnWithoutIt) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.kill();
  cell.executor.step();
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Execute);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start"}));
}

TEST(ProductionCell, StartsNoJobWhoseFileHasChanged) {
  Cell cell;
  bringToIdle(cell);
  cell.enqueue("a.gcode");
  for (const auto& file : std::filesystem::directory_iterator(cell.folder() + "/artefacts")) {
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    std::ofstream(file.path()) << "G28";
  }
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("a.gcode"), std::string::npos);
  EXPECT_TRUE(cell.executor.orders.empty());
}

TEST(ProductionCell, EndsNoJobBeforeItsLastLayer) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  EXPECT_EQ(cell.command(UnitCommand::Complete), CommandResult::GuardFailed);
  EXPECT_EQ(cell.journal().job(job).state, JobState::Running);
}

TEST(ProductionCell, StartsNothingBesideWhatIsAtWorkAndClearsIt) {
  Cell cell;
  cell.executor.report = {ExecutorPhase::Running, 0, "another.gcode", 100, {}, 0, ""};
  cell.kill();
  cell.start();
  cell.enqueue("a.gcode");
  cell.command(UnitCommand::Abort);
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"abort"}));
  EXPECT_FALSE(cell.executor.isAtWork());
}

TEST(ProductionCell, KeepsAJobThatCouldNotBegin) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Starting));
  cell.executor.fail(3106, "there is no progress file");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  cell.run().acknowledge(3106, "anna", cell.now);
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "start"})) << "none of it had run";
}

TEST(ProductionCell, KeepsAHeldJobWhoseLinkIsLost) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.step();
  cell.command(UnitCommand::Hold);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.executor.fail(3101, "the port is gone");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.run().status().stop_reason->id, 1001) << "what moved the unit first";
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted) << "by what ended it";
}

TEST(ProductionCell, FollowsAnExecutorThatPausesByItself) {
  Cell cell;
  bringToIdle(cell);
  cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.executor.report.phase = ExecutorPhase::Paused;
  EXPECT_TRUE(cell.reaches(UnitState::Held));
}

TEST(ProductionCell, CompletesAJobThatWasDoneWhileItWasDead) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.step();
  cell.step();
  cell.step();
  cell.kill();
  while (cell.executor.isAtWork()) cell.executor.step();
  cell.start();
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
  EXPECT_TRUE(cell.run().isPartOnPlate());
}

TEST(ProductionCell, IgnoresReportsOfAnEarlierJob) {
  Cell cell;
  bringToIdle(cell);
  cell.enqueue("a.gcode");
  cell.enqueue("b.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  const ExecutorReport old = cell.executor.report;
  bringToIdle(cell);
  cell.run().confirmRemoval("anna", cell.now);
  cell.command(UnitCommand::Start);
  cell.run().onReport(old, cell.now);
  EXPECT_EQ(cell.state(), UnitState::Starting);
}

/// Commands, steps and kills at random: no job is begun twice or lost, and what the journal says has ended
/// was done.
TEST(ProductionCell, LosesNoJobHoweverOftenItIsKilled) {
  std::mt19937 random(3);
  const auto pick = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  Cell cell;
  std::vector<std::int64_t> jobs;
  for (int i = 0; i < 12; ++i) jobs.push_back(cell.enqueue("part" + std::to_string(i) + ".gcode"));
  for (int i = 0; i < 1500; ++i) {
    const std::size_t event = pick(40);
    if (event == 0) {
      cell.kill();
      if (pick(2) == 0) cell.executor.fail(0, "");
      cell.start();
    } else if (event < 8) {
      const std::vector<UnitCommand> often = {UnitCommand::Reset, UnitCommand::Start,  UnitCommand::Clear,
                                              UnitCommand::Hold,  UnitCommand::Unhold, UnitCommand::Stop,
                                              UnitCommand::Reset, UnitCommand::Start,  UnitCommand::Clear};
      cell.command(often[pick(often.size())],
                   cell.run().resumeWaits() ? CutOffJob::Resume : CutOffJob::Undecided);
    } else if (event == 8) {
      for (const ActiveAlarm& alarm : std::vector<ActiveAlarm>(cell.run().status().alarms.all()))
        cell.run().acknowledge(alarm.id, "anna", cell.now);
      cell.run().confirmRemoval("anna", cell.now);
    } else {
      cell.step();
    }
  }
  std::size_t ended = 0;
  for (const std::int64_t id : jobs) ended += cell.journal().job(id).state == JobState::Ended;
  EXPECT_EQ(ended, cell.run().status().counters.parts);
  EXPECT_GT(ended, 1U);
  for (const auto& [program, times] : cell.executor.begun) EXPECT_EQ(times, 1) << program;
  EXPECT_FALSE(cell.journal().firstBadAudit());
}

}  // namespace
}  // namespace lamina
