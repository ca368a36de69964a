// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/journal_copies.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {
namespace {

constexpr double kDay = 86400.0;
constexpr double kNoon = 1'764'000'000.0 - 4.0 * 3600.0;  // 2025-11-24, 12:00 UTC

TEST(JournalCopies, AreDueOnceADayFromTheirHourOn) {
  const ScratchFolder folder;
  const CellJournal journal(folder.path() + "/cell.db");
  const JournalCopySettings settings;
  EXPECT_EQ(copyDue(folder.path(), kNoon, settings), "copies/cell-2025-11-24.db");
  copyJournal(folder.path(), "copies/cell-2025-11-24.db", 7);
  EXPECT_EQ(copyDue(folder.path(), kNoon, settings), "");
  EXPECT_EQ(copyDue(folder.path(), kNoon + 14.9 * 3600.0, settings), "") << "before three of the next day";
  EXPECT_EQ(copyDue(folder.path(), kNoon + 15.0 * 3600.0, settings), "copies/cell-2025-11-25.db");
  JournalCopySettings none;
  none.hour = -1;
  EXPECT_EQ(copyDue(folder.path(), kNoon + kDay, none), "");
}

TEST(JournalCopies, AreWholeAndTheLastOnesAreKept) {
  const ScratchFolder folder;
  CellJournal journal(folder.path() + "/cell.db");
  const std::int64_t job = journal.addJob({"bracket", "", "gantry", {}, "anna", 0}, 1.0);
  for (int day = 0; day < 5; ++day)
    copyJournal(folder.path(), copyDue(folder.path(), kNoon + day * kDay, {}), 3);
  std::size_t copies = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() + "/copies")) {
    ++copies;
    EXPECT_GE(entry.path().filename().string(), "cell-2025-11-26.db");
    EXPECT_EQ(CellJournal::read(entry.path()).job(job).name, "bracket");
  }
  EXPECT_EQ(copies, 3U);
}

TEST(JournalCopies, AreDueAndRefusedWhereTheirFolderCannotBeLookedInto) {
  const ScratchFolder folder;
  const CellJournal journal(folder.path() + "/cell.db");
  std::filesystem::create_directory_symlink("copies", folder.path() + "/copies");  // a link to itself
  const std::string due = copyDue(folder.path(), kNoon, {});
  EXPECT_EQ(due, "copies/cell-2025-11-24.db");
  EXPECT_THROW(copyJournal(folder.path(), due, 7), FileError);
}

/// As on a full disk; 0 if the copy was refused and nothing is left of it.
int copyOnAFullDisk(const std::string& folder) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{20'000, 20'000};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    copyJournal(folder, "copies/cell-2025-11-24.db", 7);
  } catch (const FileError&) {
    return std::filesystem::is_empty(folder + "/copies") ? 0 : 1;
  }
  return 2;
}

TEST(JournalCopies, LeaveNothingOnAFullDisk) {
  const ScratchFolder folder;
  CellJournal journal(folder.path() + "/cell.db");
  for (int i = 0; i < 20; ++i) journal.add(TransitionRow{1.0, 1, 6, 6, 0, std::string(5000, 'x'), ""});
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(copyOnAFullDisk(folder.path()));
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << WEXITSTATUS(status);
}

}  // namespace
}  // namespace lamina
