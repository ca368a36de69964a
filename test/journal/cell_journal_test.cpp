// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/cell_journal.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/journal/artefact_store.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

std::string journalIn(const ScratchFolder& folder) { return folder.path() + "/cell.db"; }

NewJob bracket() {
  return {"bracket", "bracket.stl", "gantry", {{"ab12", 10, "program", "bracket.gcode"}}, "anna"};
}

/// Runs a statement on a journal file from outside.
void tamper(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
}

TEST(CellJournal, KeepsAJobFromTheQueueToItsEnd) {
  const ScratchFolder folder;
  std::int64_t id = 0;
  {
    CellJournal journal(journalIn(folder));
    id = journal.addJob(bracket(), 100.0);
    EXPECT_FALSE(journal.next()) << "nobody has released it";
    journal.release(id, "anna", 101.0);
    ASSERT_TRUE(journal.next());
    EXPECT_EQ(journal.next()->id, id);
  }
  CellJournal journal(journalIn(folder));
  const std::int64_t execution = journal.begin(id, "anna", 102.0);
  EXPECT_EQ(journal.job(id).state, JobState::Running);
  EXPECT_FALSE(journal.next());
  journal.setProgress(execution, {512, 300, 4, 1234.5, 99.5}, 103.0);
  journal.interrupt(execution, "vacuum lost", 104.0);
  EXPECT_EQ(journal.queue().front().state, JobState::Interrupted);
  journal.goOn(execution, 105.0);
  journal.end(execution, JobState::Ended, "", 106.0);
  EXPECT_FALSE(journal.open());
  EXPECT_TRUE(journal.queue().empty());
  EXPECT_EQ(journal.job(id).state, JobState::Ended);
  EXPECT_EQ(journal.job(id).artefacts.size(), 1U);
}

TEST(CellJournal, KnowsAnExecutionThatWasCutOff) {
  const ScratchFolder folder;
  std::int64_t execution = 0;
  {
    CellJournal journal(journalIn(folder));
    const std::int64_t id = journal.addJob(bracket(), 1.0);
    journal.release(id, "anna", 1.0);
    execution = journal.begin(id, "anna", 2.0);
    journal.setProgress(execution, {512, 300, 4, 1234.5, 99.5}, 3.0);
  }
  const CellJournal journal(journalIn(folder));
  const auto open = journal.open();
  ASSERT_TRUE(open);
  EXPECT_EQ(open->id, execution);
  EXPECT_EQ(open->progress.sent_through, 512U);
  EXPECT_EQ(open->progress.taken_through, 300U);
  EXPECT_EQ(open->progress.layer, 4);
  EXPECT_DOUBLE_EQ(open->progress.path_mm, 1234.5);
}

TEST(CellJournal, BeginsNoJobTwiceAndNoneBesideAnother) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  const std::int64_t first = journal.addJob(bracket(), 1.0);
  const std::int64_t second = journal.addJob(bracket(), 1.0);
  EXPECT_THROW(journal.begin(first, "anna", 2.0), InvalidInput) << "not released";
  journal.release(first, "anna", 2.0);
  journal.release(second, "anna", 2.0);
  EXPECT_THROW(journal.release(first, "anna", 2.0), InvalidInput);
  const std::int64_t execution = journal.begin(first, "anna", 3.0);
  EXPECT_THROW(journal.begin(first, "anna", 4.0), InvalidInput);
  EXPECT_THROW(journal.begin(second, "anna", 4.0), InvalidInput);
  EXPECT_THROW(journal.remove(first, "anna", 4.0), InvalidInput);
  journal.end(execution, JobState::Aborted, "heater fault", 5.0);
  EXPECT_THROW(journal.end(execution, JobState::Ended, "", 6.0), InvalidInput);
  EXPECT_THROW(journal.begin(first, "anna", 6.0), InvalidInput) << "an aborted job is not begun again";
  EXPECT_GT(journal.begin(second, "anna", 7.0), execution);
}

TEST(CellJournal, OrdersTheQueueAsOperatorsMoveIt) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  const std::int64_t first = journal.addJob(bracket(), 1.0);
  const std::int64_t second = journal.addJob(bracket(), 1.0);
  const std::int64_t third = journal.addJob(bracket(), 1.0);
  journal.moveToFront(third, "anna", 2.0);
  journal.remove(first, "anna", 3.0);
  std::vector<std::int64_t> order;
  for (const QueuedJob& job : journal.queue()) order.push_back(job.id);
  EXPECT_EQ(order, (std::vector<std::int64_t>{third, second}));
  EXPECT_THROW(journal.remove(first, "anna", 4.0), InvalidInput);
  EXPECT_THROW(journal.revoke(second, "anna", 4.0), InvalidInput);
}

TEST(CellJournal, MovesAJobToAnyPlaceOfTheQueue) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  std::vector<std::int64_t> jobs;
  jobs.reserve(4);
  for (int i = 0; i < 4; ++i) jobs.push_back(journal.addJob(bracket(), 1.0));
  journal.remove(jobs[1], "anna", 2.0);
  const auto order = [&journal] {
    std::vector<std::int64_t> ids;
    for (const QueuedJob& job : journal.queue()) ids.push_back(job.id);
    return ids;
  };
  journal.moveTo(jobs[0], 2, "anna", 3.0);
  EXPECT_EQ(order(), (std::vector<std::int64_t>{jobs[2], jobs[0], jobs[3]}));
  journal.moveTo(jobs[3], 1, "anna", 4.0);
  EXPECT_EQ(order(), (std::vector<std::int64_t>{jobs[3], jobs[2], jobs[0]}));
  journal.moveTo(jobs[3], 3, "anna", 5.0);
  EXPECT_EQ(order(), (std::vector<std::int64_t>{jobs[2], jobs[0], jobs[3]}));
  EXPECT_THROW(journal.moveTo(jobs[0], 0, "anna", 6.0), InvalidInput);
  EXPECT_THROW(journal.moveTo(jobs[0], 4, "anna", 6.0), InvalidInput);
  EXPECT_THROW(journal.moveTo(jobs[1], 1, "anna", 6.0), InvalidInput) << "it was removed";
  EXPECT_EQ(order(), (std::vector<std::int64_t>{jobs[2], jobs[0], jobs[3]}));
  const std::int64_t last = journal.addJob(bracket(), 7.0);
  EXPECT_EQ(order().back(), last) << "a new job comes last";
  EXPECT_FALSE(journal.firstBadAudit());
}

TEST(CellJournal, KeepsWhatHappened) {
  const ScratchFolder folder;
  {
    CellJournal journal(journalIn(folder));
    journal.add(TransitionRow{1.5, 1, 6, 10, 4, "plc", "zone"});
    journal.add(AlarmRow{1.5, 3202, 20.25, 'H', "vacuum is 20 kPa"});
    journal.setCounters({{"parts", 3.0}, {"state.6", 12.5}});
  }
  const CellJournal journal(journalIn(folder));
  ASSERT_EQ(journal.transitions(10).size(), 1U);
  EXPECT_EQ(journal.transitions(10)[0].to, 10);
  EXPECT_EQ(journal.transitions(10)[0].source, "plc");
  ASSERT_EQ(journal.alarms(10).size(), 1U);
  EXPECT_DOUBLE_EQ(journal.alarms(10)[0].value, 20.25);
  EXPECT_EQ(journal.alarms(10)[0].category, 'H');
  EXPECT_DOUBLE_EQ(journal.counters().at("state.6"), 12.5);
}

TEST(CellJournal, KnowsWhichAlarmsAreNotSettled) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  EXPECT_FALSE(journal.unsettled(3202));
  journal.add(AlarmRow{1.0, 3202, 20.0, 'H', "first"});
  journal.add(AlarmRow{2.0, 3202, 21.0, 'H', "second"});
  journal.add(AlarmRow{3.0, 1207, 0.0, 'T', ""});
  ASSERT_TRUE(journal.unsettled(3202));
  EXPECT_EQ(journal.unsettled(3202)->message, "second");
  EXPECT_EQ(journal.unsettled(3202)->execution, 0);
  journal.acknowledgeAlarm(3202, "anna", 4.0);
  ASSERT_TRUE(journal.unsettled(3202)) << "it is still there";
  EXPECT_DOUBLE_EQ(journal.unsettled(3202)->time_s, 2.0);
  journal.endAlarm(3202, 5.0);
  EXPECT_FALSE(journal.unsettled(3202));
  journal.endAlarm(1207, 5.0);
  ASSERT_TRUE(journal.unsettled(1207)) << "nobody has acknowledged it";
  EXPECT_EQ(journal.unsettled(1207)->category, 'T');
}

TEST(CellJournal, KeepsWhatBelongsTogetherOrNoneOfIt) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  const std::int64_t job = journal.addJob(bracket(), 100.0);
  journal.release(job, "anna", 101.0);
  const std::int64_t execution = journal.begin(job, "anna", 102.0);
  EXPECT_THROW(journal.together([&] {
    journal.end(execution, JobState::Ended, "", 103.0);
    journal.setCounters({{"parts", 1.0}});
    throw FileError("disk full");
  }),
               FileError);
  EXPECT_TRUE(journal.open());
  EXPECT_TRUE(journal.counters().empty());
  journal.together([&] {
    journal.end(execution, JobState::Ended, "", 104.0);
    journal.setCounters({{"parts", 1.0}});
  });
  EXPECT_FALSE(journal.open());
  EXPECT_EQ(journal.counters().at("parts"), 1.0);
  EXPECT_FALSE(journal.firstBadAudit());
}

TEST(CellJournal, NamesTheFirstRowOfTheAuditThatWasChanged) {
  const auto written = [](const ScratchFolder& folder) {
    CellJournal journal(journalIn(folder));
    for (int i = 0; i < 5; ++i) journal.add(AuditRow{1.0 * i, "anna", "127.0.0.1", "Hold", "accepted"});
  };
  const std::vector<std::pair<std::string, std::int64_t>> changes = {
      {"UPDATE audit SET who = 'bert' WHERE id = 3", 3},
      {"DELETE FROM audit WHERE id = 2", 2},
      {"DELETE FROM audit WHERE id = 5", 5},
      {"INSERT INTO audit VALUES (6, 9.0, 'x', '', 'Stop', 'accepted', 'ab')", 6},
  };
  for (const auto& [change, row] : changes) {
    const ScratchFolder folder;
    written(folder);
    EXPECT_FALSE(CellJournal(journalIn(folder)).firstBadAudit());
    tamper(journalIn(folder), change);
    EXPECT_EQ(CellJournal(journalIn(folder)).firstBadAudit(), row) << change;
  }
}

TEST(CellJournal, MovesADamagedJournalAsideAndDeletesNothing) {
  const ScratchFolder folder;
  { CellJournal(journalIn(folder)).addJob(bracket(), 1.0); }
  {
    std::fstream file(journalIn(folder), std::ios::in | std::ios::out | std::ios::binary);
    file.write("this is no database at all", 26);
  }
  const CellJournal journal(journalIn(folder));
  EXPECT_EQ(journal.movedAside(), journalIn(folder) + ".damaged1");
  EXPECT_TRUE(fs::exists(journal.movedAside()));
  EXPECT_TRUE(journal.queue().empty());
  EXPECT_TRUE(CellJournal(journalIn(folder)).movedAside().empty());
}

TEST(CellJournal, RefusesTheFileOfALaterVersion) {
  const ScratchFolder folder;
  { const CellJournal journal(journalIn(folder)); }
  tamper(journalIn(folder), "PRAGMA user_version = 99");
  EXPECT_THROW(CellJournal{journalIn(folder)}, FileError);
  EXPECT_THROW(CellJournal{folder.path() + "/nowhere/cell.db"}, FileError);
}

TEST(CellJournal, IsCopiedWhole) {
  const ScratchFolder folder;
  CellJournal journal(journalIn(folder));
  const std::int64_t id = journal.addJob(bracket(), 1.0);
  journal.backUp(folder.path() + "/copy.db");
  EXPECT_EQ(CellJournal(folder.path() + "/copy.db").job(id).name, "bracket");
}

/// Writes transitions until it is killed, and says through the pipe how many were reported as kept.
[[noreturn]] void writeUntilKilled(const std::string& path, int pipe) {
  CellJournal journal(path);
  for (int i = 1;; ++i) {
    journal.add(TransitionRow{1.0 * i, 1, 6, 6, 0, "writer", ""});
    if (write(pipe, &i, sizeof i) != static_cast<ssize_t>(sizeof i)) _exit(1);
  }
}

TEST(CellJournal, LosesNothingThatWasAnsweredWhenItsProcessIsKilled) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const ScratchFolder folder;
    { const CellJournal journal(journalIn(folder)); }
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) writeUntilKilled(journalIn(folder), ends[1]);
    close(ends[1]);
    int answered = 0;
    const int until = 1 + static_cast<int>(random() % 40);
    while (answered < until)
      ASSERT_EQ(read(ends[0], &answered, sizeof answered), static_cast<ssize_t>(sizeof answered));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    while (read(ends[0], &answered, sizeof answered) == static_cast<ssize_t>(sizeof answered)) {
    }
    close(ends[0]);
    const CellJournal journal(journalIn(folder));
    EXPECT_TRUE(journal.movedAside().empty());
    const std::vector<TransitionRow> rows = journal.transitions(100'000);
    ASSERT_GE(static_cast<int>(rows.size()), answered);
    for (std::size_t i = 0; i < rows.size(); ++i)
      ASSERT_DOUBLE_EQ(rows[i].time_s, 1.0 * static_cast<double>(i + 1));
  }
}

/// Writes beyond the size that files may have, as on a full disk; 0 if the refusal left the journal whole.
int fillTheDisk(const std::string& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  CellJournal journal(path);
  const rlimit limit{400'000, 400'000};
  setrlimit(RLIMIT_FSIZE, &limit);
  int kept = 0;
  try {
    for (;; ++kept) journal.add(TransitionRow{1.0 * kept, 1, 6, 6, 0, std::string(5000, 'x'), ""});
  } catch (const FileError&) {
  }
  return static_cast<int>(journal.transitions(100'000).size()) == kept && kept > 5 ? 0 : 1;
}

TEST(CellJournal, SaysThatTheDiskIsFullAndKeepsWhatItHas) {
  const ScratchFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(fillTheDisk(journalIn(folder)));
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  const CellJournal journal(journalIn(folder));
  EXPECT_TRUE(journal.movedAside().empty());
}

TEST(ArtefactStore, KeepsFilesByTheirDigest) {
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/a.gcode") << "abc";
  ArtefactStore store(folder.path() + "/artefacts");
  const Artefact kept = store.keep(folder.path() + "/a.gcode", "program", "a.gcode");
  // FIPS 180-4's example.
  EXPECT_EQ(kept.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(kept.bytes, 3U);
  EXPECT_TRUE(store.torn({kept}).empty());
  EXPECT_EQ(store.keep(folder.path() + "/a.gcode", "program", "b.gcode").sha256, kept.sha256);
  fs::permissions(store.pathOf(kept), fs::perms::owner_all);
  std::ofstream(store.pathOf(kept)) << "abd";
  EXPECT_EQ(store.torn({kept}), (std::vector<std::string>{"a.gcode"}));
  EXPECT_THROW(store.keep(folder.path() + "/none.gcode", "program", "none"), FileError);
  store.keep(folder.path() + "/a.gcode", "program", "a.gcode");
  EXPECT_TRUE(store.torn({kept}).empty()) << "kept anew";
}

TEST(JobDigest, DependsOnTheFilesAloneAndNotOnTheirOrder) {
  const Artefact program{"11", 1, "program", "a"};
  const Artefact mesh{"22", 1, "mesh", "b"};
  EXPECT_EQ(jobDigest({program, mesh}), jobDigest({mesh, program}));
  EXPECT_NE(jobDigest({program, mesh}), jobDigest({program}));
  EXPECT_EQ(jobDigest({program}), sha256Of(std::string_view("program 11\n")));
}

}  // namespace
}  // namespace lamina
