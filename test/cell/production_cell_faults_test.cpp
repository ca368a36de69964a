// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A cell whose journal, machine or asker fails.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "cell/cell_on_disk.hpp"

namespace lamina {
namespace {

using test::bringToExecute;
using test::bringToIdle;
using test::Cell;

/// The journal as another process sees it.
class OtherEnd {
 public:
  explicit OtherEnd(const std::string& folder) {
    EXPECT_EQ(sqlite3_open((folder + "/cell.db").c_str(), &database_), SQLITE_OK);
  }
  ~OtherEnd() { sqlite3_close(database_); }
  OtherEnd(const OtherEnd&) = delete;
  OtherEnd& operator=(const OtherEnd&) = delete;

  void run(const std::string& statement) {
    EXPECT_EQ(sqlite3_exec(database_, statement.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database_);
  }
  int rowsOf(const std::string& table) {
    sqlite3_stmt* statement = nullptr;
    const std::string query = "SELECT COUNT(*) FROM " + table;
    EXPECT_EQ(sqlite3_prepare_v2(database_, query.c_str(), -1, &statement, nullptr), SQLITE_OK);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
    const int rows = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    return rows;
  }

 private:
  sqlite3* database_ = nullptr;
};

/// Takes the table of executions away from the journal, and gives it back: until then none can begin or end.
class MissingExecutions {
 public:
  explicit MissingExecutions(const std::string& folder) : other_(folder) {
    other_.run("ALTER TABLE execution RENAME TO execution_away");
  }
  ~MissingExecutions() { other_.run("ALTER TABLE execution_away RENAME TO execution"); }
  MissingExecutions(const MissingExecutions&) = delete;
  MissingExecutions& operator=(const MissingExecutions&) = delete;

 private:
  OtherEnd other_;
};

TEST(ProductionCell, StaysInCompletingUntilTheEndIsWritten) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  {
    const MissingExecutions missing(cell.folder());
    ASSERT_TRUE(cell.reaches(UnitState::Completing));
    for (int i = 0; i < 60; ++i) cell.step();
    EXPECT_EQ(cell.state(), UnitState::Completing);
    EXPECT_TRUE(cell.hasAlarm(7003));
  }
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
  EXPECT_EQ(cell.run().status().counters.parts, 1U);
  EXPECT_FALSE(cell.run().resumeWaits());
}

TEST(ProductionCell, WritesTheRecordOfAPartOnceItsFolderCanBeSearchedAgain) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  const std::string artefacts = cell.folder() + "/artefacts";
  std::filesystem::rename(artefacts, artefacts + "_away");
  std::filesystem::create_symlink(artefacts, artefacts);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_TRUE(cell.hasAlarm(7003));
  for (int i = 0; i < 300; ++i) cell.step();  // 15 s, beyond the next write of the counters
  EXPECT_TRUE(cell.hasAlarm(7003));
  ExecutionLog log(cell.journal());
  EXPECT_FALSE(log.part(log.ofJob(job)->id));
  std::filesystem::remove(artefacts);
  std::filesystem::rename(artefacts + "_away", artefacts);
  for (int i = 0; i < 40; ++i) cell.step();
  ASSERT_TRUE(log.part(log.ofJob(job)->id));
  EXPECT_EQ(log.part(log.ofJob(job)->id)->verdict, "good");
}

TEST(ProductionCell, DiscardsNoJobWhoseEndCannotBeWritten) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.kill();
  cell.executor.fail(0, "");
  cell.start();
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  cell.run().confirmRemoval("anna", cell.now);
  {
    const MissingExecutions missing(cell.folder());
    cell.command(UnitCommand::Start, CutOffJob::Discard);
    for (int i = 0; i < 10; ++i) cell.step();
  }
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start"})) << "neither resumed nor begun";
  EXPECT_NE(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_TRUE(cell.run().resumeWaits());
}

TEST(ProductionCell, KeepsAJobThatIsStoppedBecauseItCannotBeHeldYet) {
  UnitSettings settings;
  settings.hold_rule = HoldRule::InExecute;
  Cell cell(settings);
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_EQ(cell.state(), UnitState::Starting);
  cell.run().raise(2101, 0.0, "the PLC's heartbeat does not come", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  cell.run().end(2101, cell.now);
  cell.run().acknowledge(2101, "anna", cell.now);
  bringToIdle(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted)
      << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
}

TEST(ProductionCell, KeepsTheJobOfAStreamerThatDiedWhetherItsMachineStopsAtOnceOrNot) {
  for (const int alarm : {2203, 2204}) {
    Cell cell;
    const std::int64_t job = bringToExecute(cell);
    cell.step();
    cell.run().raise(alarm, 0.0, "the streamer has died", cell.now);
    ASSERT_TRUE(cell.reaches(UnitState::Aborted)) << alarm;
    EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted) << alarm;
  }
}

/// Why the last execution was interrupted or ended, as its record has it.
std::string reasonOf(Cell& cell, std::int64_t job) {
  const auto execution = ExecutionLog(cell.journal()).ofJob(job);
  return execution ? execution->reason : "no execution";
}

TEST(ProductionCell, KeepsWhyAJobWasCutOffOrEnded) {
  const std::string lost = "2201 executor lost: no sign of life";
  const std::string silent = "2202 executor does not answer: for 2 s";
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.run().raise(2201, 0.0, "no sign of life", cell.now);
  cell.run().raise(2202, 2.0, "for 2 s", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(reasonOf(cell, job), lost + "; then " + silent);
  const auto open = cell.journal().open();
  ASSERT_TRUE(open);
  EXPECT_EQ(ExecutionLog(cell.journal()).gaps(open->id).back().reason, lost + "; then " + silent);
  Cell failed;
  const std::int64_t failed_job = bringToExecute(failed);
  failed.executor.fail(3104, "the nozzle reads 400 degC");
  ASSERT_TRUE(failed.reaches(UnitState::Aborted));
  EXPECT_EQ(reasonOf(failed, failed_job), "3104 heater fault: the nozzle reads 400 degC");
  Cell stopped;
  const std::int64_t stopped_job = bringToExecute(stopped);
  stopped.command(UnitCommand::Hold);
  ASSERT_TRUE(stopped.reaches(UnitState::Held));
  EXPECT_EQ(reasonOf(stopped, stopped_job), "1001 held by the operator: by anna");
  stopped.command(UnitCommand::Stop);
  ASSERT_TRUE(stopped.reaches(UnitState::Stopped));
  EXPECT_EQ(reasonOf(stopped, stopped_job), "Stop by anna") << "it was not ended because it was held";
}

/// The numbers of the alarms of an execution.
std::vector<int> alarmsOf(Cell& cell, std::int64_t execution) {
  std::vector<int> numbers;
  for (const AlarmRecord& row : ExecutionLog(cell.journal()).alarms(execution)) {
    numbers.push_back(row.alarm.alarm);
    EXPECT_TRUE(row.gone_s) << row.alarm.alarm << " is an event";
  }
  return numbers;
}

TEST(ProductionCell, WritesTheAlarmsThatTheUnitRaisesItself) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  const std::int64_t execution = ExecutionLog(cell.journal()).ofJob(job)->id;
  cell.command(UnitCommand::Hold);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.command(UnitCommand::Abort);
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  ASSERT_EQ(alarmsOf(cell, execution), (std::vector<int>{1001, 1002}));
  EXPECT_EQ(ExecutionLog(cell.journal()).alarms(execution)[1].alarm.message, "by anna");
}

TEST(ProductionCell, WritesThatAStateLastsTooLong) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  const std::int64_t execution = ExecutionLog(cell.journal()).ofJob(job)->id;
  cell.command(UnitCommand::Hold);
  cell.now.steady_s += 31.0;  // 30 s are allowed to Holding, and the executor says nothing
  cell.run().tick(cell.now);
  ASSERT_EQ(cell.state(), UnitState::Aborting);
  EXPECT_EQ(alarmsOf(cell, execution), (std::vector<int>{1001, 1010}));
  cell.now.steady_s += 21.0;  // 20 s to Aborting
  cell.run().tick(cell.now);
  ASSERT_EQ(cell.state(), UnitState::Aborted);
  EXPECT_EQ(alarmsOf(cell, execution), (std::vector<int>{1001, 1010, 1010}));
  EXPECT_NE(reasonOf(cell, job).find("1010 a state lasted too long: Holding has lasted 31 s"),
            std::string::npos);
  EXPECT_NE(reasonOf(cell, job).find("; Aborting has lasted 21 s"), std::string::npos);
}

/// Whether the cause of an alarm is present.
bool isPresent(Cell& cell, int id) {
  const auto& alarms = cell.run().status().alarms.all();
  return std::any_of(alarms.begin(), alarms.end(),
                     [id](const ActiveAlarm& alarm) { return alarm.id == id && !alarm.gone_s; });
}

// The node reads the journal too: what it cannot read is not what the cell could not write.
TEST(ProductionCell, EndsTheAlarmOfAJournalThatSomebodyElseCouldNotRead) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  for (int i = 0; i < 60; ++i) {
    cell.step();  // 50 ms
    cell.run().raise(7003, 0.0, "the queue cannot be read", cell.now);
    EXPECT_TRUE(isPresent(cell, 7003)) << i;
  }
  ASSERT_EQ(cell.state(), UnitState::Held);
  cell.run().acknowledge(7003, "anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::GuardFailed);
  for (int i = 0; i < 21; ++i) cell.step();
  EXPECT_FALSE(cell.hasAlarm(7003)) << "it was read and written for a second";
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted) << cell.answer.reason;
  for (const AlarmRecord& row : ExecutionLog(cell.journal()).alarms(cell.journal().open()->id))
    EXPECT_TRUE(row.gone_s) << row.alarm.alarm;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
}

TEST(ProductionCell, WritesAnAlarmThatComesBackWithinASecond) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  const std::int64_t execution = ExecutionLog(cell.journal()).ofJob(job)->id;
  const double began_s = cell.now.utc_s;
  cell.run().raise(1204, 0.0, "", cell.now);
  for (int i = 0; i < 6; ++i) cell.step();  // 0.3 s
  cell.run().end(1204, cell.now);
  for (int i = 0; i < 6; ++i) cell.step();
  cell.run().raise(1204, 0.0, "", cell.now);
  for (int i = 0; i < 7; ++i) cell.step();
  EXPECT_EQ(ExecutionLog(cell.journal()).alarms(execution).size(), 1U) << "0.95 s after the first";
  for (int i = 0; i < 100; ++i) cell.step();
  const auto rows = ExecutionLog(cell.journal()).alarms(execution);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(rows[0].gone_s.value_or(0.0), began_s + 0.3, 1e-3);
  EXPECT_NEAR(rows[1].alarm.time_s, began_s + 0.6, 1e-3);
  EXPECT_FALSE(rows[1].gone_s) << "the zone is still taken";
}

TEST(ProductionCell, WritesAnAlarmWhoseValueIsNoNumber) {
  Cell cell;
  bringToExecute(cell);
  OtherEnd other(cell.folder());
  const int before = other.rowsOf("alarm");
  cell.run().raise(6101, std::numeric_limits<double>::quiet_NaN(), "nothing for 3 s", cell.now);
  EXPECT_EQ(cell.state(), UnitState::Execute);
  EXPECT_TRUE(cell.hasAlarm(6101));
  EXPECT_FALSE(cell.hasAlarm(7003));
  EXPECT_EQ(other.rowsOf("alarm"), before + 1);
}

TEST(ProductionCell, OffersTheJobThatAnEmergencyStopHasStopped) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.step();
  cell.run().raise(1207, 0.0, "", cell.now);
  EXPECT_EQ(cell.executor.orders.back(), "stop");
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  EXPECT_EQ(cell.command(UnitCommand::Reset), CommandResult::GuardFailed) << "it is still pressed";
}

/// Whether Unhold waits for somebody to acknowledge an alarm, and for nothing else; then the job is printed.
void expectAcknowledgementOnly(Cell& cell, int alarm) {
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("alarm " + std::to_string(alarm)), std::string::npos)
      << cell.answer.reason;
  EXPECT_NE(cell.answer.reason.find("is not acknowledged"), std::string::npos) << cell.answer.reason;
  cell.run().acknowledge(alarm, "anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted) << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
}

TEST(ProductionCell, WaitsForTheAcknowledgementOfAnAlarmThatItsProcessDidNotOutlive) {
  Cell cell;
  bringToExecute(cell);
  cell.run().raise(3202, 20.0, "vacuum is 20 kPa", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.kill();
  cell.now.utc_s += 5.0;
  cell.now.steady_s += 5.0;
  cell.start();
  ASSERT_EQ(cell.state(), UnitState::Held);
  ASSERT_TRUE(cell.run().status().stop_reason);
  EXPECT_EQ(cell.run().status().stop_reason->id, 3202);
  EXPECT_EQ(cell.run().status().stop_reason->message, "vacuum is 20 kPa");
  EXPECT_LT(cell.run().status().stop_reason->raised_s, cell.now.steady_s - 5.0);
  expectAcknowledgementOnly(cell, 3202);
  bringToIdle(cell);
  cell.kill();
  cell.start();
  EXPECT_FALSE(cell.hasAlarm(3202)) << "it was acknowledged, and was of an earlier run";
}

TEST(ProductionCell, WaitsOverARestartForWhatWasAcknowledgedButStillThere) {
  Cell cell;
  bringToExecute(cell);
  cell.run().raise(3202, 20.0, "vacuum is 20 kPa", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.run().acknowledge(3202, "anna", cell.now);
  cell.run().raise(4102, 0.0, "", cell.now);
  cell.kill();
  cell.start();
  EXPECT_FALSE(cell.hasAlarm(4102)) << "warnings are not latched";
  expectAcknowledgementOnly(cell, 3202);
}

TEST(ProductionCell, HoldsTheJobOfAnAlarmThatItDiedOf) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  // Written, and killed before the executor was asked to pause.
  cell.journal().add(AlarmRow{cell.now.utc_s, 3202, 20.0, 'H', "vacuum is 20 kPa"});
  cell.kill();
  cell.start();
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  EXPECT_EQ(cell.executor.orders.back(), "pause");
  expectAcknowledgementOnly(cell, 3202);
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
}

TEST(ProductionCell, LeavesTheJobThatIsRunAloneWhenAnAlarmIsOfAnEarlierOne) {
  Cell cell;
  cell.journal().add(AlarmRow{cell.now.utc_s, 3104, 0.0, 'A', "of a print that ended long ago"});
  bringToExecute(cell);
  cell.kill();
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Execute);
  EXPECT_TRUE(cell.hasAlarm(3104)) << "it waits to be acknowledged";
}

/// Acknowledges what is there and brings the unit to Idle.
void recover(Cell& cell) {
  for (const ActiveAlarm& alarm : std::vector<ActiveAlarm>(cell.run().status().alarms.all())) {
    cell.run().end(alarm.id, cell.now);
    cell.run().acknowledge(alarm.id, "anna", cell.now);
  }
  if (cell.state() == UnitState::Aborted) cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
}

/// The first job of a stopped machine is not resumed, but it may be discarded; the next one starts.
void expectDiscardOnly(Cell& cell, std::int64_t job) {
  const std::vector<UnmetGuard> against = cell.run().againstResuming();
  ASSERT_EQ(against.size(), 1U);
  EXPECT_EQ(against.front().code, 1313);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("lost motions"), std::string::npos) << cell.answer.reason;
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  EXPECT_EQ(cell.executor.orders.front(), "start");
  EXPECT_EQ(cell.executor.resumed.size(), 0U);
  const std::int64_t next = cell.enqueue("b.gcode");
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Discard), CommandResult::Accepted)
      << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_TRUE(cell.run().againstResuming().empty()) << "of a job that nobody asks for any more";
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_EQ(cell.journal().job(next).state, JobState::Ended);
}

TEST(ProductionCell, ResumesNoJobWhoseMachineWasStoppedWithIt) {
  {
    Cell cell;
    const std::int64_t job = bringToExecute(cell);
    cell.step();
    cell.executor.end(2202, "the node was ended");
    ASSERT_TRUE(cell.reaches(UnitState::Aborted));
    recover(cell);
    expectDiscardOnly(cell, job);
  }
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.step();
  cell.run().raise(1207, 0.0, "", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  recover(cell);
  expectDiscardOnly(cell, job);
}

TEST(ProductionCell, RemembersOverARestartThatMotionsAreLost) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.step();
  cell.run().raise(1207, 0.0, "", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  cell.kill();
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Aborted);
  recover(cell);
  expectDiscardOnly(cell, job);
}

TEST(ProductionCell, ResumesAJobThatWasStoppedBeforeItsFirstLine) {
  Cell cell;
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  cell.command(UnitCommand::Start);
  ASSERT_EQ(cell.state(), UnitState::Starting);
  cell.run().raise(1207, 0.0, "", cell.now);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  recover(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted)
      << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
}

TEST(ProductionCell, ResumesNothingOnAnExecutorThatDoesNot) {
  Cell cell;
  cell.executor.kind = {"waypoint", "the driver keeps no progress"};
  const std::int64_t job = bringToExecute(cell);
  for (int i = 0; i < 3; ++i) cell.step();
  cell.executor.fail(3101, "the controller is silent");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  const std::uint64_t reached = cell.journal().open()->progress.taken_through;
  EXPECT_GT(reached, 0U);
  recover(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("was cut off after waypoint " + std::to_string(reached)),
            std::string::npos)
      << cell.answer.reason;
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("the driver keeps no progress"), std::string::npos) << cell.answer.reason;
  ASSERT_EQ(cell.run().againstResuming().size(), 1U);
  EXPECT_EQ(cell.run().againstResuming().front().code, 1314);
  const std::int64_t next = cell.enqueue("b.gcode");
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Discard), CommandResult::Accepted)
      << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_EQ(cell.journal().job(next).state, JobState::Ended);
}

// Whatever the executor reports on its way there: a second kill must not lose the place.
TEST(ProductionCell, KeepsWhatIsLaidWhileItsJobIsResumed) {
  Cell cell;
  bringToExecute(cell);
  cell.executor.report.progress.path_mm = 120.0;
  for (int i = 0; i < 3; ++i) cell.step();
  cell.executor.fail(3101, "the controller is silent");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  const ExecutionProgress before = cell.journal().open()->progress;
  EXPECT_EQ(before.path_mm, 120.0);
  recover(cell);
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted)
      << cell.answer.reason;
  EXPECT_EQ(cell.executor.progress.path_mm, 120.0) << "the order has it";
  EXPECT_EQ(cell.executor.progress.taken_through, before.taken_through);
  cell.executor.report.progress = {};
  cell.run().onReport(cell.executor.report, cell.now);
  cell.now.steady_s += 1.0;
  cell.run().onReport(cell.executor.report, cell.now);
  const ExecutionProgress after = cell.journal().open()->progress;
  EXPECT_EQ(after.path_mm, 120.0);
  EXPECT_EQ(after.deposited_mm3, before.deposited_mm3);
  EXPECT_EQ(after.taken_through, before.taken_through);
  EXPECT_EQ(after.sent_through, before.sent_through);
}

TEST(ProductionCell, TakesThePlateToBeOccupiedWhenTheJournalIsLost) {
  Cell cell;
  EXPECT_FALSE(cell.run().isPartOnPlate());
  cell.kill();
  std::ofstream(cell.folder() + "/cell.db", std::ios::binary) << "this is no database at all";
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Aborted);
  EXPECT_TRUE(cell.run().isPartOnPlate()) << "what lay on it stood in the journal that is lost";
  cell.step();
  cell.kill();
  cell.start();
  EXPECT_TRUE(cell.run().isPartOnPlate()) << "until somebody says that it is empty";
  cell.run().confirmRemoval("anna", cell.now);
  EXPECT_FALSE(cell.run().isPartOnPlate());
}

TEST(ProductionCell, WritesOneRowASecondOfWhatIsRefusedAgainAndAgain) {
  Cell cell;
  OtherEnd other(cell.folder());
  const int before = other.rowsOf("audit");
  for (int i = 0; i < 100; ++i) {
    cell.step();  // 50 ms
    EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::NotInThisState);
  }
  const int rows = other.rowsOf("audit") - before;
  EXPECT_GE(rows, 5);
  EXPECT_LE(rows, 6);
  EXPECT_EQ(cell.command(UnitCommand::Reset), CommandResult::Accepted);
  EXPECT_EQ(other.rowsOf("audit"), before + rows + 1);
}

}  // namespace
}  // namespace lamina
