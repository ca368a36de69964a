// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/child_process.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "lamina/base/error.hpp"

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

}  // namespace
}  // namespace lamina
