// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Remembers what was reported; cancels after a number of reports.
class Watcher final : public Progress {
 public:
  explicit Watcher(std::size_t cancel_after = SIZE_MAX) : cancel_after_(cancel_after) {}
  void report(const std::string& stage, double fraction) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    stages_.push_back(stage);
    fractions_.push_back(fraction);
  }
  bool isCancelled() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return fractions_.size() >= cancel_after_;
  }
  const std::vector<double>& fractions() const { return fractions_; }
  const std::vector<std::string>& stages() const { return stages_; }

 private:
  std::size_t cancel_after_;
  mutable std::mutex mutex_;
  std::vector<double> fractions_;
  std::vector<std::string> stages_;
};

TEST(ParallelFor, CallsTheBodyOnceForEachIndex) {
  NoProgress progress;
  std::vector<int> calls(1000, 0);
  parallelFor(
      calls.size(), [&](std::size_t i) { ++calls[i]; }, progress, "count");
  EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 1000);
  EXPECT_EQ(*std::min_element(calls.begin(), calls.end()), 1);
}

TEST(ParallelFor, OverNothingDoesNothing) {
  NoProgress progress;
  parallelFor(
      0, [](std::size_t) { FAIL(); }, progress, "nothing");
}

TEST(ParallelFor, ReportsFractionsUpToOneUnderItsStage) {
  Watcher watcher;
  parallelFor(
      500, [](std::size_t) {}, watcher, "plan");
  ASSERT_FALSE(watcher.fractions().empty());
  EXPECT_LE(watcher.fractions().size(), 101U);
  EXPECT_DOUBLE_EQ(*std::max_element(watcher.fractions().begin(), watcher.fractions().end()), 1.0);
  EXPECT_EQ(watcher.stages().front(), "plan");
}

TEST(ParallelFor, StopsWhenCancelledNamingTheStage) {
  Watcher watcher(3);
  std::atomic<int> calls{0};
  try {
    parallelFor(
        100000, [&](std::size_t) { ++calls; }, watcher, "plan");
    FAIL() << "nothing thrown";
  } catch (const Cancelled& error) {
    EXPECT_NE(std::string(error.what()).find("plan"), std::string::npos);
  }
  EXPECT_LT(calls, 100000);
}

TEST(ParallelFor, PassesOnWhatABodyThrows) {
  NoProgress progress;
  const auto body = [](std::size_t i) {
    if (i == 700) throw InvalidInput("the seven hundredth");
  };
  EXPECT_THROW(parallelFor(1000, body, progress, "plan"), InvalidInput);
}

TEST(ParallelFor, GivesTheSameOnOneThread) {
  const ThreadLimit limit(1);
  NoProgress progress;
  std::vector<std::size_t> squares(100);
  parallelFor(
      squares.size(), [&](std::size_t i) { squares[i] = i * i; }, progress, "square");
  for (std::size_t i = 0; i < squares.size(); ++i) EXPECT_EQ(squares[i], i * i);
}

TEST(ParallelFor, ALoopWithinOneThatFailsStillEndsItsWorkOrThrows) {
  NoProgress progress;
  std::atomic<int> cut_short{0};
  for (int run = 0; run < 20; ++run) {
    const auto fails = [&](std::size_t i) {
      if (i == 40) throw InvalidInput("no");
      std::vector<double> sums(500);
      parallelFor(
          sums.size(),
          [&](std::size_t k) {
            for (int n = 1; n < 200; ++n) sums[k] += 1.0 / n;
          },
          progress, "inner");
      if (std::count(sums.begin(), sums.end(), 0.0) > 0) ++cut_short;
    };
    EXPECT_THROW(parallelFor(100, fails, progress, "outer"), InvalidInput);
  }
  EXPECT_EQ(cut_short, 0);
}

TEST(InParallel, RunsBoth) {
  int first = 0;
  int second = 0;
  inParallel([&] { first = 1; }, [&] { second = 2; });
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 2);
}

TEST(InParallel, PassesOnWhatOneThrows) {
  const auto nothing = [] {};
  const auto refuses = [] { throw InvalidInput("no"); };
  EXPECT_THROW(inParallel(nothing, refuses), InvalidInput);
  EXPECT_THROW(inParallel(refuses, nothing), InvalidInput);
}

TEST(ThrowIfCancelled, ThrowsOnlyIfCancelled) {
  EXPECT_NO_THROW(throwIfCancelled(Watcher(1), "slice"));
  EXPECT_THROW(throwIfCancelled(Watcher(0), "slice"), Cancelled);
}

}  // namespace
}  // namespace lamina
