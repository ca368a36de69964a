// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/queue_follower.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cell/cell_on_disk.hpp"

namespace lamina {
namespace {

using test::bringToExecute;
using test::bringToIdle;
using test::Cell;

StartOutlook nothingAgainst() {
  StartOutlook outlook;
  outlook.found.start.is_checked = true;
  outlook.found.start.machine = {"gantry", ""};
  outlook.found.start.free_bytes = 1e10;
  return outlook;
}

/// A cell whose first job is complete, with a second one that is released, and its queue.
struct QueuedCell {
  explicit QueuedCell(QueueAdvance rule = QueueAdvance::Automatic) : queue(rule) {
    bringToExecute(cell);
    second = cell.enqueue("b.gcode");
    EXPECT_TRUE(reaches(UnitState::Complete));
  }
  bool reaches(UnitState state) {
    for (int i = 0; i < 400 && cell.state() != state; ++i) step();
    return cell.state() == state;
  }
  void step() {
    cell.step();
    follow();
  }
  void follow() {
    queue.follow(
        cell.run(), [this] { return outlook; }, cell.now);
  }

  Cell cell;
  QueueFollower queue;
  StartOutlook outlook = nothingAgainst();
  std::int64_t second = 0;
};

TEST(QueueFollower, StartsTheNextJobOnceThePartWasTakenAway) {
  QueuedCell made;
  EXPECT_FALSE(made.reaches(UnitState::Idle)) << "the part is there";
  EXPECT_NE(made.queue.waitsFor().find("not confirmed as removed"), std::string::npos);
  made.cell.run().confirmRemoval("anna", made.cell.now);
  ASSERT_TRUE(made.reaches(UnitState::Execute));
  EXPECT_EQ(made.cell.journal().job(made.second).state, JobState::Running);
  ASSERT_TRUE(made.reaches(UnitState::Complete));
  EXPECT_EQ(made.cell.run().status().counters.parts, 2U);
  made.cell.run().confirmRemoval("anna", made.cell.now);
  EXPECT_FALSE(made.reaches(UnitState::Idle)) << "the queue is empty";
  EXPECT_NE(made.queue.waitsFor().find("no job of the queue"), std::string::npos);
}

TEST(QueueFollower, AsksUnlessItIsAutomatic) {
  QueuedCell made(QueueAdvance::Ask);
  made.cell.run().confirmRemoval("anna", made.cell.now);
  EXPECT_FALSE(made.reaches(UnitState::Idle));
}

TEST(QueueFollower, WaitsInIdleForWhatIsAgainstTheStart) {
  QueuedCell made;
  made.outlook.found.start.plc_need = PlcNeed::Required;
  made.outlook.found.start.plc.is_alive = true;  // and reports neither plate nor supplies
  made.cell.run().confirmRemoval("anna", made.cell.now);
  ASSERT_TRUE(made.reaches(UnitState::Idle));
  EXPECT_FALSE(made.reaches(UnitState::Execute));
  EXPECT_NE(made.queue.waitsFor().find("build plate"), std::string::npos);
  EXPECT_EQ(made.cell.journal().firstBadAudit(), std::nullopt);
  made.outlook.found.start.plc = {true, true, true, true, true, true, true, false, false, false};
  EXPECT_TRUE(made.reaches(UnitState::Execute));
}

TEST(QueueFollower, WaitsForAPersonAfterStopAndAbort) {
  for (const UnitCommand command : {UnitCommand::Stop, UnitCommand::Abort}) {
    QueuedCell made;
    made.cell.run().confirmRemoval("anna", made.cell.now);
    ASSERT_EQ(made.cell.command(command), CommandResult::Accepted);
    made.follow();
    const bool is_abort = command == UnitCommand::Abort;
    ASSERT_TRUE(made.reaches(is_abort ? UnitState::Aborted : UnitState::Stopped));
    for (const ActiveAlarm& alarm : std::vector<ActiveAlarm>(made.cell.run().status().alarms.all()))
      made.cell.run().acknowledge(alarm.id, "anna", made.cell.now);
    if (is_abort) {
      ASSERT_EQ(made.cell.command(UnitCommand::Clear), CommandResult::Accepted);
    }
    ASSERT_TRUE(made.reaches(UnitState::Stopped));
    ASSERT_EQ(made.cell.command(UnitCommand::Reset), CommandResult::Accepted);
    made.follow();
    ASSERT_TRUE(made.reaches(UnitState::Idle));
    EXPECT_FALSE(made.reaches(UnitState::Execute)) << toString(command);
  }
}

TEST(QueueFollower, StartsNothingAfterTheResetOfAPerson) {
  QueuedCell made;
  ASSERT_EQ(made.cell.command(UnitCommand::Reset), CommandResult::Accepted);
  made.follow();
  made.cell.run().confirmRemoval("anna", made.cell.now);
  ASSERT_TRUE(made.reaches(UnitState::Idle));
  EXPECT_FALSE(made.reaches(UnitState::Execute));
  EXPECT_EQ(made.cell.command(UnitCommand::Start), CommandResult::Accepted) << made.cell.answer.reason;
}

TEST(QueueFollower, StartsNothingWhenTheProcessBegins) {
  QueuedCell made;
  made.cell.run().confirmRemoval("anna", made.cell.now);
  made.cell.kill();
  made.cell.start();
  made.queue = QueueFollower(QueueAdvance::Automatic);
  bringToIdle(made.cell);
  EXPECT_FALSE(made.reaches(UnitState::Execute));
}

TEST(QueueFollower, WaitsForAnAlarmThatNobodyHasAcknowledged) {
  QueuedCell made;
  made.cell.run().confirmRemoval("anna", made.cell.now);
  made.cell.run().raise(2101, 0.0, "the PLC's heartbeat does not come", made.cell.now);
  EXPECT_FALSE(made.reaches(UnitState::Idle));
  EXPECT_NE(made.queue.waitsFor().find("2101"), std::string::npos);
  made.cell.run().end(2101, made.cell.now);
  made.cell.run().acknowledge(2101, "anna", made.cell.now);
  EXPECT_TRUE(made.reaches(UnitState::Execute));
}

TEST(QueueFollower, AsksOnceForAStartThatTheJobsFileForbids) {
  QueuedCell made;
  for (const auto& file : std::filesystem::directory_iterator(made.cell.folder() + "/artefacts")) {
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    std::ofstream(file.path()) << "G28";
  }
  made.cell.run().confirmRemoval("anna", made.cell.now);
  ASSERT_TRUE(made.reaches(UnitState::Idle));
  EXPECT_FALSE(made.reaches(UnitState::Execute));
  EXPECT_NE(made.queue.waitsFor().find("b.gcode"), std::string::npos);
  EXPECT_EQ(made.cell.executor.orders, (std::vector<std::string>{"start"}));
}

}  // namespace
}  // namespace lamina
