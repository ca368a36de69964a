// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/execution_log.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"

namespace lamina {
namespace {

/// A journal with one job that has begun.
struct BegunJob {
  ScratchFolder folder;
  CellJournal journal{folder.path() + "/cell.db"};
  ExecutionLog log{journal};
  std::int64_t job = 0;
  std::int64_t execution = 0;

  BegunJob() {
    journal.add(TransitionRow{1.0, 1, 2, 3, 2, "anna", ""});  // of an execution that never began
    job = journal.addJob({"bracket", "bracket.stl", "gantry", {}, "anna", 12}, 1.0);
    journal.release(job, "anna", 2.0);
    journal.add(TransitionRow{3.0, 1, 4, 3, 2, "anna", ""});
    execution = journal.begin(job, "bert", 3.0);
    journal.add(TransitionRow{4.0, 1, 3, 6, 0, "unit", ""});
  }
};

TEST(ExecutionLog, KnowsAnExecutionByItsJob) {
  BegunJob begun;
  EXPECT_EQ(begun.journal.job(begun.job).layers, 12);
  begun.journal.setProgress(begun.execution, {50, 40, 3, 1.0, 2.0}, 4.0);
  const auto found = begun.log.ofJob(begun.job);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->operator_name, "bert");
  EXPECT_EQ(found->progress.taken_through, 40U);
  EXPECT_FALSE(found->ended_s);
  begun.journal.end(begun.execution, JobState::Ended, "", 9.0);
  EXPECT_EQ(begun.log.execution(begun.execution).ended_s, 9.0);
  EXPECT_EQ(begun.log.execution(begun.execution).outcome, JobState::Ended);
  EXPECT_FALSE(begun.log.ofJob(begun.job + 1));
  EXPECT_THROW(begun.log.execution(99), InvalidInput);
}

TEST(ExecutionLog, AddsToWhatIsKnownOfALayer) {
  BegunJob begun;
  LayerRow began;
  began.layer = 2;
  began.began_s = 5.0;
  begun.log.setLayer(begun.execution, began);
  LayerRow measured;
  measured.layer = 2;
  measured.mean_mm = -0.02;
  measured.correction = "ab12";
  begun.log.setLayer(begun.execution, measured);
  began.began_s = 6.0;
  began.ended_s = 7.0;
  begun.log.setLayer(begun.execution, began);
  const std::vector<LayerRow> layers = begun.log.layers(begun.execution);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_EQ(layers[0].began_s, 5.0) << "it begins once";
  EXPECT_EQ(layers[0].ended_s, 7.0);
  EXPECT_EQ(layers[0].mean_mm, -0.02);
  EXPECT_EQ(layers[0].correction, "ab12");
  EXPECT_FALSE(layers[0].coverage);
}

TEST(ExecutionLog, KeepsValuesTransitionsAlarmsAndGaps) {
  BegunJob begun;
  begun.log.add(begun.execution, {5.0, "feed", 0.8, "plc"});
  begun.journal.add(AlarmRow{6.0, 3202, 20.0, 'H', "vacuum is 20 kPa"});
  begun.journal.setProgress(begun.execution, {50, 40, 3, 1.0, 2.0}, 6.0);
  begun.journal.interrupt(begun.execution, "vacuum lost", 6.0);
  begun.journal.interrupt(begun.execution, "and again", 6.5);
  begun.journal.acknowledgeAlarm(3202, "anna", 7.0);
  begun.journal.endAlarm(3202, 8.0);
  begun.journal.acknowledgeAlarm(3202, "bert", 9.0);
  begun.journal.goOn(begun.execution, 9.0);
  EXPECT_EQ(begun.log.setpoints(begun.execution).at(0).value, 0.8);
  ASSERT_EQ(begun.log.transitions(begun.execution).size(), 2U) << "from the one that began it on";
  EXPECT_EQ(begun.log.transitions(begun.execution)[0].time_s, 3.0);
  const auto alarms = begun.log.alarms(begun.execution);
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].acknowledged_by, "anna");
  EXPECT_EQ(alarms[0].acknowledged_s, 7.0);
  EXPECT_EQ(alarms[0].gone_s, 8.0);
  const auto gaps = begun.log.gaps(begun.execution);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].began_s, 6.0);
  EXPECT_EQ(gaps[0].ended_s, 9.0);
  EXPECT_EQ(gaps[0].line, 40U);
  EXPECT_EQ(gaps[0].reason, "vacuum lost");
  begun.journal.goOn(begun.execution, 20.0);
  ASSERT_EQ(begun.log.gaps(begun.execution).size(), 2U) << "of a job that was cut off without a word";
  EXPECT_EQ(begun.log.gaps(begun.execution)[1].reason, "cut off") << "since its last progress";
}

TEST(ExecutionLog, NamesThePartAndItsRemoval) {
  BegunJob begun;
  EXPECT_FALSE(begun.log.part(begun.execution));
  const PartRow part{"1-1", "good", "unit", {}, "", {"ab12", 7, "record", "record.json"}};
  begun.log.setPart(begun.execution, part, 5.0);
  begun.log.removePart("plc", 8.0);
  begun.log.removePart("anna", 9.0);
  const auto found = begun.log.part(begun.execution);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->serial, "1-1");
  EXPECT_EQ(found->record.sha256, "ab12");
  EXPECT_EQ(found->removed_by, "plc");
  EXPECT_EQ(found->removed_s, 8.0);
}

TEST(ExecutionLog, ReadsAJournalOfTheFirstVersion) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/cell.db";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  const std::string sql = readFile(std::string(LAMINA_TEST_DATA) + "/cell_journal_1.sql");
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
  EXPECT_THROW(CellJournal::read(path), FileError) << "reading brings nothing forward";
  CellJournal journal(path);
  ExecutionLog log(journal);
  EXPECT_EQ(journal.job(7).layers, 0);
  ASSERT_TRUE(log.ofJob(7));
  EXPECT_EQ(log.ofJob(7)->progress.layer, 2);
  EXPECT_EQ(log.alarms(3).at(0).alarm.alarm, 3202);
  EXPECT_TRUE(log.layers(3).empty());
}

TEST(ExecutionLog, IsReadWhileItsCellWrites) {
  BegunJob begun;
  CellJournal reading = CellJournal::read(begun.folder.path() + "/cell.db");
  begun.log.add(begun.execution, {5.0, "feed", 0.8, "plc"});
  EXPECT_EQ(ExecutionLog(reading).setpoints(begun.execution).size(), 1U);
  EXPECT_THROW(reading.release(begun.job, "anna", 1.0), Error);
  EXPECT_THROW(CellJournal::read(begun.folder.path() + "/none.db"), FileError);
}

}  // namespace
}  // namespace lamina
