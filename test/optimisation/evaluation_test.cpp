// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {
namespace {

/// Cancelled once that many points were tried.
class CancelAfter final : public Progress {
 public:
  explicit CancelAfter(const std::atomic<int>& tried, int most) : tried_(tried), most_(most) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return tried_ >= most_; }

 private:
  const std::atomic<int>& tried_;
  int most_;
};

TEST(ParallelEvaluatorTest, AnswersInTheOrderOfThePointsAndReportsEachOnce) {
  ParallelEvaluator evaluator({"square"}, [](const DesignPoint& point, Progress&) {
    return std::vector<double>{point[0] * point[0]};
  });
  std::vector<DesignPoint> points;
  for (int i = 0; i < 100; ++i) points.push_back({static_cast<double>(i)});
  std::vector<int> reported(100);
  NoProgress progress;
  const auto evaluations = evaluator.evaluate(
      points, [&](const Evaluation& e) { ++reported[static_cast<std::size_t>(e.point[0])]; }, progress);
  ASSERT_EQ(evaluations.size(), 100U);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(evaluations[i].responses, std::vector<double>{static_cast<double>(i * i)});
    EXPECT_EQ(reported[i], 1);
  }
}

TEST(ParallelEvaluatorTest, RecordsAPointThatCannotBeTriedWithItsError) {
  ParallelEvaluator evaluator({"root"}, [](const DesignPoint& point, Progress&) {
    if (point[0] < 0.0) throw InvalidInput("root of -1");
    return std::vector<double>{1.0};
  });
  NoProgress progress;
  const auto evaluations = evaluator.evaluate({{1.0}, {-1.0}}, {}, progress);
  EXPECT_TRUE(isEvaluated(evaluations[0]));
  EXPECT_FALSE(isEvaluated(evaluations[1]));
  EXPECT_EQ(evaluations[1].error, "root of -1");
  EXPECT_TRUE(evaluations[1].responses.empty());
}

TEST(ParallelEvaluatorTest, TakesNoFailureForSuccess) {
  ParallelEvaluator evaluator({"a", "b"}, [](const DesignPoint& point, Progress&) {
    if (point[0] < 0.0) throw InvalidInput("");
    return std::vector<double>(static_cast<std::size_t>(point[0]), 1.0);
  });
  NoProgress progress;
  const auto evaluations = evaluator.evaluate({{-1.0}, {1.0}, {2.0}, {3.0}}, {}, progress);
  EXPECT_EQ(evaluations[0].error, "an exception without a message");
  EXPECT_EQ(evaluations[1].error, "1 responses were measured; expected 2");
  EXPECT_TRUE(evaluations[1].responses.empty());
  EXPECT_TRUE(isEvaluated(evaluations[2]));
  EXPECT_EQ(evaluations[3].error, "3 responses were measured; expected 2");
}

TEST(ParallelEvaluatorTest, StopsWhenCancelledAndHasReportedWhatWasDone) {
  std::atomic<int> tried{0};
  ParallelEvaluator evaluator({"count"}, [&](const DesignPoint&, Progress& progress) {
    throwIfCancelled(progress, "evaluate");
    ++tried;
    return std::vector<double>{0.0};
  });
  int reported = 0;
  CancelAfter progress(tried, 5);
  EXPECT_THROW(
      evaluator.evaluate(
          std::vector<DesignPoint>(1000, DesignPoint{0.0}), [&](const Evaluation&) { ++reported; }, progress),
      Cancelled);
  EXPECT_EQ(reported, tried);
  EXPECT_LT(tried, 1000);
}

}  // namespace
}  // namespace lamina
