// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/journal/progress_keeper.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <memory>
#include <system_error>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kNeverWaited = 60.0;  // s; nothing here waits so long

JobProgress takenThrough(std::uint64_t lines) {
  JobProgress progress;
  progress.taken_through = lines;
  return progress;
}

/// A disk that answers the first write when it is told to, and all others at once.
struct SlowDisk {
  std::promise<void> asked;
  std::promise<void> answers;
  std::vector<std::uint64_t> written;  ///< lines of each write

  ProgressKeeper::Write write() {
    return [this, may_go_on = answers.get_future().share()](const JobProgress& progress) {
      if (written.empty()) {
        asked.set_value();
        may_go_on.wait();
      }
      written.push_back(progress.taken_through);
    };
  }
};

TEST(ProgressKeeper, WritesTheLatestAndMakesNobodyWait) {
  SlowDisk disk;
  {
    ProgressKeeper keeper(disk.write(), kNeverWaited);
    keeper.keep(takenThrough(1), 0.0);
    disk.asked.get_future().wait();
    EXPECT_FALSE(keeper.hasWritten());
    keeper.keep(takenThrough(2), 1.0);
    keeper.keep(takenThrough(3), 2.0);
    EXPECT_EQ(keeper.failure(2.0), "");
    disk.answers.set_value();
  }
  EXPECT_EQ(disk.written, (std::vector<std::uint64_t>{1, 3})) << "the last one is waited for";
}

TEST(ProgressKeeper, GivesUpADiskThatDoesNotAnswer) {
  // It outlives the keeper, as its thread does.
  const auto disk = std::make_shared<SlowDisk>();
  const SteadyClock clock;
  const double begin_s = clock.now();
  {
    ProgressKeeper keeper([disk, write = disk->write()](const JobProgress& progress) { write(progress); },
                          kNeverWaited);
    keeper.keep(takenThrough(1), 100.0);
    disk->asked.get_future().wait();
    EXPECT_EQ(keeper.failure(160.0), "");
    EXPECT_NE(keeper.failure(160.1).find("within 60 s"), std::string::npos);
  }
  EXPECT_LT(clock.now() - begin_s, kNeverWaited) << "nor is it waited for at the end";
  disk->answers.set_value();
}

TEST(ProgressKeeper, SaysWhyADiskFails) {
  ProgressKeeper keeper([](const JobProgress&) { throw FileError("no space left"); }, kNeverWaited);
  keeper.keep(takenThrough(1), 0.0);
  while (keeper.failure(0.0).empty()) std::this_thread::yield();
  EXPECT_EQ(keeper.failure(0.0), "no space left");
  EXPECT_FALSE(keeper.hasWritten());
}

TEST(ProgressKeeper, SurvivesWhatAFileSystemThrows) {
  ProgressKeeper keeper(
      [](const JobProgress&) {
        throw std::filesystem::filesystem_error("looking", std::make_error_code(std::errc::io_error));
      },
      kNeverWaited);
  keeper.keep(takenThrough(1), 0.0);
  while (keeper.failure(0.0).empty()) std::this_thread::yield();
  EXPECT_NE(keeper.failure(0.0).find("Input/output error"), std::string::npos) << keeper.failure(0.0);
}

}  // namespace
}  // namespace lamina
