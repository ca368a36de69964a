// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/production_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "cell/cell_on_disk.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {
namespace {

using test::bringToExecute;
using test::bringToIdle;
using test::Cell;

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
  const std::int64_t job = bringToExecute(cell);
  EXPECT_EQ(cell.command(UnitCommand::Hold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "pause", "resume"}));
}

/// Brings a stopped cell to Starting with a job. @return the job
std::int64_t bringToStarting(Cell& cell) {
  bringToIdle(cell);
  const std::int64_t job = cell.enqueue("a.gcode");
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted);
  EXPECT_EQ(cell.state(), UnitState::Starting);
  return job;
}

TEST(ProductionCell, HoldsAJobThatStartsAndGoesOnFromItsFirstLine) {
  Cell cell;
  const std::int64_t job = bringToStarting(cell);
  EXPECT_EQ(cell.command(UnitCommand::Hold), CommandResult::Accepted);
  EXPECT_EQ(cell.state(), UnitState::Holding);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  EXPECT_TRUE(cell.executor.begun.empty()) << "no line was sent";
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Running);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "pause", "resume"}));
  EXPECT_EQ(cell.executor.begun.size(), 1U);
}

TEST(ProductionCell, AsksAgainForAPauseThatCameBeforeTheJob) {
  Cell cell;
  bringToStarting(cell);
  cell.executor.pauses_not_heard = 2;
  cell.executor.report.lines = 1000;  // it goes on meanwhile
  EXPECT_EQ(cell.command(UnitCommand::Hold), CommandResult::Accepted);
  const double held_s = cell.now.steady_s;
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start", "pause", "pause", "pause"}));
  EXPECT_NEAR(cell.now.steady_s - held_s, 1.0, 0.2) << "twice half a second, and no order at each tick";
}

TEST(ProductionCell, HoldsForWhatWouldSuspendItWhileItStarts) {
  for (const int alarm : {1204, 3201}) {
    Cell cell;
    bringToStarting(cell);
    cell.run().raise(alarm, 0.0, "", cell.now);
    EXPECT_EQ(cell.state(), UnitState::Holding);
    ASSERT_TRUE(cell.reaches(UnitState::Held));
    EXPECT_TRUE(cell.executor.begun.empty());
    EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::GuardFailed) << "its cause is there";
    cell.run().end(alarm, cell.now);
    cell.run().acknowledge(alarm, "anna", cell.now);
    EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted) << cell.answer.reason;
    ASSERT_TRUE(cell.reaches(UnitState::Complete));
  }
}

TEST(ProductionCell, HoldsAgainOnItsWayBack) {
  Cell cell;
  bringToExecute(cell);
  cell.command(UnitCommand::Hold);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.command(UnitCommand::Unhold);
  ASSERT_EQ(cell.state(), UnitState::Unholding);
  EXPECT_EQ(cell.command(UnitCommand::Hold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.command(UnitCommand::Unhold);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
}

TEST(ProductionCell, EndsTheJobItStops) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.command(UnitCommand::Stop);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Aborted);
  EXPECT_FALSE(cell.journal().open());
}

TEST(ProductionCell, AbortsWhenTheMachineFails) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
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
  const std::int64_t job = bringToExecute(cell);
  cell.step();
  cell.executor.fail(3101, "the port is gone");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted);
  cell.run().acknowledge(3101, "anna", cell.now);
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  EXPECT_TRUE(cell.run().resumeWaits());
  EXPECT_TRUE(cell.run().againstResuming().empty());
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
  EXPECT_TRUE(cell.run().againstResuming().empty());
  cell.run().confirmRemoval("anna", cell.now);
  ASSERT_EQ(cell.run().againstResuming().size(), 1U);
  EXPECT_EQ(cell.run().againstResuming().front().code, 1311);
  EXPECT_NE(cell.run().againstResuming().front().sentence.find("discard its job"), std::string::npos)
      << "by this the page tells it from what goes by";
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::GuardFailed)
      << "and now it is not";
  EXPECT_EQ(cell.command(UnitCommand::Start, CutOffJob::Discard), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(first).state, JobState::Aborted);
  EXPECT_EQ(cell.journal().job(second).state, JobState::Ended);
}

TEST(ProductionCell, AdoptsAJobThatRunsOnWithoutIt) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.kill();
  cell.executor.step();
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Execute);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
  EXPECT_EQ(cell.executor.orders, (std::vector<std::string>{"start"}));
}

/// While a resumed job is planned, and on its approach, its executor reports none of it.
TEST(ProductionCell, KeepsThePlaceOfAResumedJobThatItAdoptsOnItsWay) {
  Cell cell;
  bringToExecute(cell);
  for (int i = 0; i < 4; ++i) cell.step();
  cell.executor.fail(3101, "the controller is silent");
  cell.step();
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  const ExecutionProgress laid{25, 20, 2, 312.5, 10.0};
  cell.journal().setProgress(cell.journal().open()->id, laid, cell.now.utc_s);
  cell.run().acknowledge(3101, "anna", cell.now);
  cell.command(UnitCommand::Clear);
  ASSERT_TRUE(cell.reaches(UnitState::Stopped));
  bringToIdle(cell);
  ASSERT_EQ(cell.command(UnitCommand::Start, CutOffJob::Resume), CommandResult::Accepted)
      << cell.answer.reason;
  ASSERT_EQ(cell.executor.report.phase, ExecutorPhase::Starting);
  cell.executor.report.progress = {0, 0, 0, 0.0, 0.0};
  cell.kill();
  cell.start();
  EXPECT_EQ(cell.state(), UnitState::Starting);
  cell.executor.fail(4105, "no way to the start");
  cell.step();
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  const ExecutionProgress kept = cell.journal().open()->progress;
  EXPECT_EQ(kept.sent_through, 25U) << "else it begins anew, onto the part";
  EXPECT_EQ(kept.taken_through, 20U);
  EXPECT_EQ(kept.layer, 2);
  EXPECT_EQ(kept.path_mm, 312.5);
  EXPECT_EQ(kept.deposited_mm3, 10.0);
}

/// Handed over, and perhaps run: that none of it was reached says nothing of that.
TEST(ProductionCell, TakesNothingBackThatWasHandedOver) {
  const ExecutionProgress now = furthest({7, 0, -1, 0.0, 0.0}, {0, 0, -1, 0.0, 0.0});
  EXPECT_EQ(now.sent_through, 7U);
}

/// What was laid before the length was lost is no measure of the part.
TEST(ProductionCell, KeepsNoPartOfALengthThatIsNotKnownAnyMore) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ExecutionProgress now = furthest({7, 5, 0, 120.0, 30.0}, {8, 6, 0, nan, nan});
  EXPECT_EQ(now.path_mm, 0.0);
  EXPECT_EQ(now.deposited_mm3, 0.0);
  EXPECT_EQ(now.taken_through, 6U);
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
  const std::int64_t job = bringToExecute(cell);
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
  const std::int64_t job = bringToExecute(cell);
  cell.step();
  cell.command(UnitCommand::Hold);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.executor.fail(3101, "the port is gone");
  ASSERT_TRUE(cell.reaches(UnitState::Aborted));
  EXPECT_EQ(cell.run().status().stop_reason->id, 1001) << "what moved the unit first";
  EXPECT_EQ(cell.journal().job(job).state, JobState::Interrupted) << "by what ended it";
}

TEST(ProductionCell, StartsNoJobOnAnotherMachineOfTheSameName) {
  const std::string large =
      "machine: gantry\ndescription: SHA-256 aa\nreach in x: -150 to 150 mm\nreach in y: 0 to 9 mm\n";
  const std::string small =
      "machine: gantry\ndescription: SHA-256 bb\nreach in x: -50 to 50 mm\nreach in y: 0 to 9 mm\n";
  Cell cell;
  bringToIdle(cell);
  const std::int64_t old = cell.enqueue("old.gcode");  // of a version that kept the machine's name alone
  cell.machine_sheet = large;
  const std::int64_t job = cell.enqueue("a.gcode");
  EXPECT_NE(cell.journal().job(job).digest, jobDigest({cell.journal().job(job).artefacts.back()}))
      << "of the program alone";
  cell.kill();
  cell.machine_sheet = small;
  cell.start();
  bringToIdle(cell);
  cell.journal().revoke(old, "anna", cell.now.utc_s);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::GuardFailed);
  EXPECT_NE(cell.answer.reason.find("description is SHA-256 bb; expected SHA-256 aa; "
                                    "reach in x is -50 to 50 mm; expected -150 to 150 mm; queue it anew"),
            std::string::npos)
      << cell.answer.reason;
  EXPECT_EQ(cell.answer.reason.find("reach in y"), std::string::npos) << cell.answer.reason;
  cell.machine_sheet = large;
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted) << cell.answer.reason;
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  bringToIdle(cell);
  cell.run().confirmRemoval("anna", cell.now);
  cell.journal().release(old, "anna", cell.now.utc_s);
  EXPECT_EQ(cell.command(UnitCommand::Start), CommandResult::Accepted) << cell.answer.reason;
}

TEST(ProductionCell, FollowsAnExecutorThatPausesByItself) {
  Cell cell;
  bringToExecute(cell);
  cell.executor.report.phase = ExecutorPhase::Paused;
  EXPECT_TRUE(cell.reaches(UnitState::Held));
  cell.executor.report.phase = ExecutorPhase::Running;  // somebody has pressed the machine's button
  EXPECT_TRUE(cell.reaches(UnitState::Execute));
}

TEST(ProductionCell, StaysHeldByAPersonWhateverTheExecutorDoes) {
  Cell cell;
  bringToExecute(cell);
  cell.executor.report.phase = ExecutorPhase::Paused;
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.executor.report.phase = ExecutorPhase::Running;
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.command(UnitCommand::Hold);
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.executor.report.phase = ExecutorPhase::Running;
  EXPECT_FALSE(cell.reaches(UnitState::Execute));
}

/// Lets the executor go on by itself. @return whether the unit pauses it and stays as it is
bool isPausedAgain(Cell& cell) {
  const UnitState before = cell.state();
  for (int i = 0; i < 20; ++i) cell.step();  // 1 s
  cell.executor.orders.clear();
  cell.executor.report.phase = ExecutorPhase::Running;
  for (int i = 0; i < 20; ++i) cell.step();
  return cell.executor.orders == std::vector<std::string>{"pause"} &&
         cell.executor.report.phase == ExecutorPhase::Paused && cell.state() == before;
}

TEST(ProductionCell, PausesAnExecutorThatGoesOnByItselfWhereTheUnitMayNot) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
  cell.executor.report.phase = ExecutorPhase::Paused;
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.run().raise(1208, 0.0, "the PLC reports the guard open", cell.now);
  EXPECT_TRUE(isPausedAgain(cell)) << "under an alarm";
  cell.run().acknowledge(1208, "anna", cell.now);
  EXPECT_TRUE(isPausedAgain(cell)) << "it is no longer the executor that holds it";
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.executor.report.phase = ExecutorPhase::Paused;
  ASSERT_TRUE(cell.reaches(UnitState::Held));
  cell.step();  // it hears that it is to be paused, which it is
  cell.kill();
  cell.start();
  EXPECT_TRUE(isPausedAgain(cell)) << "nobody knows any more who has held it";
  EXPECT_EQ(cell.command(UnitCommand::Unhold), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Execute));
  cell.command(UnitCommand::Suspend);
  ASSERT_TRUE(cell.reaches(UnitState::Suspended));
  EXPECT_TRUE(isPausedAgain(cell));
  EXPECT_EQ(cell.command(UnitCommand::Unsuspend), CommandResult::Accepted);
  ASSERT_TRUE(cell.reaches(UnitState::Complete));
  EXPECT_EQ(cell.journal().job(job).state, JobState::Ended);
}

TEST(ProductionCell, CompletesAJobThatWasDoneWhileItWasDead) {
  Cell cell;
  const std::int64_t job = bringToExecute(cell);
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
      // The cell was killed while its executor stopped the machine.
      if (cell.answer.reason.find("lost motions") != std::string::npos)
        cell.command(UnitCommand::Start, CutOffJob::Discard);
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
