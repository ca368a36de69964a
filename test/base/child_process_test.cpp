// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

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

/// Whether what stands in /proc is a process: there are "net" and the like, too.
bool isProcess(const std::filesystem::path& entry) {
  const std::string name = entry.filename().string();
  return name.find_first_not_of("0123456789") == std::string::npos;
}

/// Whether no process of the group runs any more. One that has ended may be listed until somebody takes
/// notice.
bool isEnded(pid_t group) {
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    if (!isProcess(process.path())) continue;
    std::ifstream file(process.path() / "stat");
    const std::string line((std::istreambuf_iterator<char>(file)), {});
    const std::size_t name_end = line.rfind(')');
    if (name_end == std::string::npos) continue;
    std::istringstream rest(line.substr(name_end + 1));
    char state = ' ';
    pid_t parent = 0;
    pid_t of_group = 0;
    rest >> state >> parent >> of_group;
    if (of_group == group && state != 'Z' && state != 'X') return false;
  }
  return true;
}

/// Until it holds, for a minute at most.
template <class Condition>
bool comesTrue(const Condition& condition) {
  const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > last) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// Whether a process runs that was started to watch the group.
bool isWatched(pid_t group) {
  const std::string watching = std::string("watcher") + '\0' + std::to_string(group) + '\0';
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    if (!isProcess(process.path())) continue;
    std::ifstream line(process.path() / "cmdline");
    const std::string words((std::istreambuf_iterator<char>(line)), {});
    if (words.find(watching) != std::string::npos) return true;
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
