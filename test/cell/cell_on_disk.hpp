// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/cell/production_cell.hpp"

namespace lamina::test {

/// An executor that does what it is asked when it is asked to, and prints ten lines a step.
class PrintingExecutor final : public Executor {
 public:
  ExecutorTraits traits() const override { return kind; }
  void start(const StartOrder& order) override {
    const bool is_known = taken.count(order.execution) > 0;
    EXPECT_TRUE(is_known || order.start != ExecutionStart::Resume) << "nothing is there to go on with";
    EXPECT_FALSE(is_known && order.start == ExecutionStart::Anew) << "it would lay lines twice";
    orders.emplace_back(is_known ? "resume job" : "start");
    progress = order.progress;
    if (is_known) ++resumed[order.program];
    execution_ = order.execution;
    const std::uint64_t from = is_known ? taken[execution_] : 0;
    report = {ExecutorPhase::Starting, order.order, order.program, 100, {from, from, -1, 0.0, 0.0}, 0, ""};
  }
  void pause() override {
    orders.emplace_back("pause");
    if (pauses_not_heard > 0 && pauses_not_heard-- > 0) return;
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
        report.has_lost_motions = report.progress.taken_through > 0;
        break;
      case ExecutorPhase::Running:
        if (report.progress.taken_through == 0) ++begun[report.program];
        report.progress.taken_through += 10;
        taken[execution_] = report.progress.taken_through;
        report.progress.sent_through = report.progress.taken_through + 5;
        report.progress.deposited_mm3 += 5.0;
        if (report.progress.taken_through >= report.lines) report.phase = ExecutorPhase::Done;
        break;
      default:
        break;
    }
  }
  /// Ends the job by stopping the machine in good order, as a streamer whose process is asked to end.
  void end(int alarm, const std::string& why) {
    fail(alarm, why);
    report.has_lost_motions = true;
  }
  void fail(int alarm, const std::string& failure) {
    report.phase = ExecutorPhase::Resting;
    report.alarm = alarm;
    report.failure = failure;
  }
  bool isAtWork() const {
    return report.phase != ExecutorPhase::Resting && report.phase != ExecutorPhase::Done;
  }

  ExecutorTraits kind;
  ExecutionProgress progress;  ///< of the last order to start
  ExecutorReport report;
  std::vector<std::string> orders;
  int pauses_not_heard = 0;                    ///< as of one that the job has not reached yet
  std::map<std::string, std::uint64_t> taken;  ///< lines, by execution: what its progress file knows
  std::map<std::string, int> begun;            ///< its first lines were sent
  std::map<std::string, int> resumed;

 private:
  std::string execution_;
};

/// A cell on disk with an executor, whose process can be killed and started again.
class Cell {
 public:
  explicit Cell(UnitSettings settings = {}) : settings_(std::move(settings)) { start(); }

  void start() {
    journal_ = std::make_unique<CellJournal>(folder_.path() + "/cell.db");
    artefacts_ = std::make_unique<ArtefactStore>(folder_.path() + "/artefacts");
    // After a restart the executor's reports speak of a job that was there before.
    if (run_once_) executor.report.order = 0;
    const auto seen = run_once_ ? std::optional<ExecutorReport>(executor.report) : std::nullopt;
    run_once_ = true;
    run_ =
        std::make_unique<ProductionCell>(settings_, CellParts{*journal_, *artefacts_, executor}, seen, now);
  }

  void kill() {
    run_.reset();
    artefacts_.reset();
    journal_.reset();
  }

  std::int64_t enqueue(const std::string& name) {
    std::ofstream(folder_.path() + "/" + name) << "G1 X1 ; " << name;
    const Artefact program = artefacts_->keep(folder_.path() + "/" + name, "program", name);
    std::vector<Artefact> artefacts = {program};
    if (!machine_sheet.empty())
      artefacts.push_back(artefacts_->keepText(machine_sheet, kMachineSheet, "machine.txt"));
    const std::int64_t id = journal_->addJob({name, name, "gantry", artefacts, "anna"}, now.utc_s);
    journal_->release(id, "anna", now.utc_s);
    return id;
  }

  CommandResult command(UnitCommand command, CutOffJob cut_off = CutOffJob::Undecided) {
    CellSurroundings found;
    found.start.is_checked = true;
    found.start.machine = {"gantry", machine_sheet};
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
  std::string machine_sheet;  ///< of the machine that is there; jobs have that of when they were queued

 private:
  ScratchFolder folder_;
  UnitSettings settings_;
  bool run_once_ = false;
  std::unique_ptr<CellJournal> journal_;
  std::unique_ptr<ArtefactStore> artefacts_;
  std::unique_ptr<ProductionCell> run_;
};

inline void bringToIdle(Cell& cell) {
  ASSERT_EQ(cell.command(UnitCommand::Reset), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Idle));
}

/// Brings a stopped cell to Execute with a job. @return the job
inline std::int64_t bringToExecute(Cell& cell) {
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted);
  EXPECT_TRUE(cell.reaches(UnitState::Execute));
  return job;
}

}  // namespace lamina::test
