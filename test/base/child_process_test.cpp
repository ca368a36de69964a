// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

int exitCodeOf(std::vector<std::string> arguments) {
  return runProgram({std::move(arguments), "", 60.0}, NoProgress()).exit_code;
}

TEST(ChildProcessTest, ReportsHowItEnded) {
  EXPECT_EQ(exitCodeOf({"true"}), 0);
  EXPECT_EQ(exitCodeOf({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(exitCodeOf({"sh", "-c", "kill -KILL $$"}), 128 + SIGKILL);
}

TEST(ChildProcessTest, TakesNoFailureForSuccessWhereEndsAreIgnored) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_THROW(exitCodeOf({"false"}), FileError);
  std::signal(SIGCHLD, before);
}

bool isEnded(pid_t group) { return ::kill(-group, 0) != 0 && errno == ESRCH; }

/// Until it holds, for a minute at most.
template <class Condition>
bool comesTrue(const Condition& condition) {
  for (int i = 0; i < 6000 && !condition(); ++i) ::usleep(10000);
  return condition();
}

/// Whether a process runs that was told to watch the group.
bool isWatched(pid_t group) {
  const std::string told = std::string("watcher") + '\0' + std::to_string(group) + '\0';
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    std::ifstream line(process.path() / "cmdline");
    const std::string words((std::istreambuf_iterator<char>(line)), {});
    if (words.find(told) != std::string::npos) return true;
  }
  return false;
}

TEST(ChildProcessTest, NothingIsLeftIfTheCallerIsKilled) {
  const test::ScratchFolder folder;
  const std::string started = folder.file("started");
  const std::string scratch = folder.file("scratch");
  std::filesystem::create_directory(scratch);
  const pid_t caller = ::fork();
  ASSERT_GE(caller, 0);
  if (caller == 0) {
    const std::string script =
        "sleep 600 & echo $$ > " + started + ".new; mv " + started + ".new " + started + "; sleep 600";
    runProgram({{"sh", "-c", script}, scratch, 600.0, scratch}, NoProgress());
    ::_exit(0);
  }
  ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(started); }));
  const pid_t group = std::stoi(readFile(started));
  EXPECT_FALSE(isEnded(group));
  ASSERT_TRUE(comesTrue([&] { return isWatched(group); }));
  ::kill(caller, SIGKILL);
  ASSERT_EQ(::waitpid(caller, nullptr, 0), caller);
  EXPECT_TRUE(comesTrue([&] { return isEnded(group); }));
  EXPECT_TRUE(comesTrue([&] { return !std::filesystem::exists(scratch); }));
}

}  // namespace
}  // namespace lamina
