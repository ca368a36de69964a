// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/evaluation_journal.hpp"
#include "lamina/optimisation/nsga2.hpp"
#include "lamina/optimisation/pareto.hpp"
#include "optimisation/variation.hpp"
#include "support/scratch_folder.hpp"
#include "test_problems.hpp"

namespace lamina {
namespace {

Nsga2Settings nsga2SettingsOf(Variation variation, int population, int generations) {
  Nsga2Settings settings;
  settings.variation = variation;
  settings.population = population;
  settings.generations = generations;
  return settings;
}

/// Cancelled once an evaluator was asked so often.
class CancelAt final : public Progress {
 public:
  CancelAt(const CountingEvaluator& evaluator, int most) : evaluator_(evaluator), most_(most) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return evaluator_.tried() >= most_; }

 private:
  const CountingEvaluator& evaluator_;
  int most_;
};

class Nsga2Test : public ::testing::TestWithParam<Variation> {
 protected:
  FrontSearch search(Evaluator& evaluator, const Nsga2Settings& settings) {
    return searchFront({mixedSpace(), timeAndError(), evaluator}, settings, {}, progress_);
  }

  NoProgress progress_;
};

TEST(Nsga2SettingsTest, TheSourcesCountsAre36ChildrenAnd20MutantsAnd1170Evaluations) {
  const Nsga2Settings settings;
  EXPECT_EQ(offspringOf(settings), 56U);
  EXPECT_EQ(evaluationsOf(settings), 1170);
  EXPECT_EQ(evaluationsOf(nsga2SettingsOf(Variation::Blend, 50, 15)), 890);
  EXPECT_EQ(evaluationsOf(nsga2SettingsOf(Variation::Sbx, 100, 250)), 25100);
}

TEST_P(Nsga2Test, AsksForAsManyEvaluationsAsItSaysAllWithinTheSpace) {
  CountingEvaluator evaluator;
  const Nsga2Settings settings = nsga2SettingsOf(GetParam(), 50, 20);
  std::vector<int> reported;
  const FrontSearch found = searchFront(
      {mixedSpace(), timeAndError(), evaluator}, settings,
      [&](const Generation& generation) { reported.push_back(generation.evaluations); }, progress_);
  EXPECT_EQ(evaluator.tried(), evaluationsOf(settings));
  EXPECT_EQ(found.evaluations.size(), static_cast<std::size_t>(evaluationsOf(settings)));
  ASSERT_EQ(reported.size(), 21U);
  EXPECT_EQ(reported.front(), 50);
  EXPECT_EQ(reported.back(), evaluationsOf(settings));
  std::vector<int> links(2);
  for (const Evaluation& evaluation : found.evaluations) {
    ASSERT_NO_THROW(requireWithin(mixedSpace(), evaluation.point));
    ++links[static_cast<std::size_t>(evaluation.point[3])];
  }
  EXPECT_GT(links[0], 0);
  EXPECT_GT(links[1], 0);
}

TEST_P(Nsga2Test, TheFrontIsNotDominatedAndBetterThanTheFirst) {
  CountingEvaluator evaluator;
  const FrontSearch found = search(evaluator, nsga2SettingsOf(GetParam(), 40, 30));
  std::vector<Score> scores;
  for (const Evaluation& one : found.front)
    scores.push_back(scoreOf(timeAndError(), evaluator.responseNames(), one));
  EXPECT_EQ(paretoFront(scores).size(), found.front.size());
  EXPECT_GT(found.generations.back().hypervolume, 1.02 * found.generations.front().hypervolume);
  EXPECT_TRUE(std::is_sorted(found.front.begin(), found.front.end(),
                             [](const auto& a, const auto& b) { return a.responses[0] < b.responses[0]; }));
}

TEST_P(Nsga2Test, TheSameSeedGivesTheSameWhateverTheNumberOfThreads) {
  Nsga2Settings settings = nsga2SettingsOf(GetParam(), 30, 10);
  CountingEvaluator evaluator;
  const std::string many = textOf(search(evaluator, settings).evaluations);
  const ThreadLimit one_thread(1);
  EXPECT_EQ(textOf(search(evaluator, settings).evaluations), many);
  settings.seed = 2;
  EXPECT_NE(textOf(search(evaluator, settings).evaluations), many);
}

TEST_P(Nsga2Test, CountsMoreEvaluationsThanAnIntHolds) {
  const Nsga2Settings few = nsga2SettingsOf(GetParam(), 100000, 1);
  const Nsga2Settings many = nsga2SettingsOf(GetParam(), 100000, 1000000);
  EXPECT_EQ(evaluationsOf(many), 100000 + 1000000 * (evaluationsOf(few) - 100000));
  EXPECT_GT(evaluationsOf(many), 10000000000);
}

TEST_P(Nsga2Test, ResumedFromItsJournalItEndsAsIfItHadNeverStopped) {
  const Nsga2Settings settings = nsga2SettingsOf(GetParam(), 20, 12);
  CountingEvaluator straight(2.0);
  const FrontSearch whole = search(straight, settings);
  const test::ScratchFolder folder;
  const std::string path = folder.file("resumed.jsonl");
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    std::remove(path.c_str());
    Random random(seed);
    CountingEvaluator inner(2.0);
    bool is_done = false;
    FrontSearch found;
    while (!is_done) {
      CancelAt cancel(inner, inner.tried() + 1 + static_cast<int>(random.below(150)));
      JournalledEvaluator journal(inner, mixedSpace(), {path, "resumed", EarlierJournal::GoOn});
      try {
        found = searchFront({mixedSpace(), timeAndError(), journal}, settings, {}, cancel);
        is_done = true;
      } catch (const Cancelled&) {
        // A run that is killed may leave half a line.
        if (random.below(2) == 0) writeFile(path, readFile(path) + R"({"point":[0.)");
      }
    }
    RC_ASSERT(textOf(found.front) == textOf(whole.front));
    RC_ASSERT(textOf(found.evaluations) == textOf(whole.evaluations));
    RC_ASSERT(found.generations.back().hypervolume == whole.generations.back().hypervolume);
  }));
}

TEST_P(Nsga2Test, WhatFailedIsCountedWithItsErrorAndNeverInAFront) {
  CountingEvaluator evaluator(1.4);
  const FrontSearch found = search(evaluator, nsga2SettingsOf(GetParam(), 30, 10));
  const auto failed = std::count_if(found.evaluations.begin(), found.evaluations.end(),
                                    [](const Evaluation& one) { return !isEvaluated(one); });
  EXPECT_GT(failed, 5);
  EXPECT_EQ(found.generations.back().failed, failed);
  for (const Generation& generation : found.generations)
    for (const Evaluation& one : generation.front) EXPECT_TRUE(isEvaluated(one));
  CountingEvaluator hopeless(0.0);
  const FrontSearch nothing = search(hopeless, nsga2SettingsOf(GetParam(), 10, 3));
  EXPECT_TRUE(nothing.front.empty());
  EXPECT_TRUE(nothing.reference.empty());
  EXPECT_EQ(nothing.generations.back().hypervolume, 0.0);
  EXPECT_EQ(static_cast<std::size_t>(nothing.generations.back().failed), nothing.evaluations.size());
}

TEST_P(Nsga2Test, AnObjectiveThatIsNoNumberIsAFailure) {
  ParallelEvaluator evaluator({"time_s", "error_mm3"}, [](const DesignPoint& point, Progress&) {
    return std::vector<double>{point[0], point[0] < 1.0 ? NAN : 1.0 / point[0]};
  });
  const FrontSearch found = search(evaluator, nsga2SettingsOf(GetParam(), 20, 5));
  EXPECT_GT(found.generations.back().failed, 0);
  for (const Evaluation& one : found.front) EXPECT_GE(one.point[0], 1.0);
  const auto failed = std::find_if(found.evaluations.begin(), found.evaluations.end(),
                                   [](const Evaluation& one) { return !isEvaluated(one); });
  EXPECT_EQ(failed->error, "objective error_mm3 is nan; must be finite");
}

TEST_P(Nsga2Test, SearchesASingleObjectiveAndOneThatIsTheSameEverywhere) {
  // Nearest to 1.7 in pitch; the second objective is 0 for all.
  ParallelEvaluator evaluator({"distance", "travel"}, [](const DesignPoint& point, Progress&) {
    return std::vector<double>{std::abs(point[0] - 1.7), 0.0};
  });
  const Objective distance{"distance", Sense::Minimise, 1.0};
  const Objective travel{"travel", Sense::Minimise, 1.0};
  for (const auto& objectives : {std::vector<Objective>{distance}, {distance, travel}}) {
    const FrontSearch found = searchFront({mixedSpace(), {objectives, {}}, evaluator},
                                          nsga2SettingsOf(GetParam(), 40, 40), {}, progress_);
    ASSERT_FALSE(found.front.empty());
    EXPECT_NEAR(found.front[0].point[0], 1.7, 1e-2);
  }
}

/// CONSTR [Deb2001]: f = x, g = (1 + y) / x with y + 9x >= 6 and 9x - y >= 1. The front is g = (7 - 9x) / x
/// along the first constraint from x = 7/18 to 2/3, then g = 1/x along y = 0.
TEST_P(Nsga2Test, FindsTheKnownFrontOfAConstrainedProblem) {
  const DesignSpace space = {continuous("x", 0.1, 1.0), continuous("y", 0.0, 5.0)};
  ParallelEvaluator evaluator({"f", "g", "sum", "difference"}, [](const DesignPoint& p, Progress&) {
    return std::vector<double>{p[0], (1.0 + p[1]) / p[0], p[1] + 9.0 * p[0], 9.0 * p[0] - p[1]};
  });
  const Goals goals{{{"f", Sense::Minimise, 1.0}, {"g", Sense::Minimise, 1.0}},
                    {{"sum", 6.0, INFINITY}, {"difference", 1.0, INFINITY}}};
  Nsga2Settings settings = nsga2SettingsOf(GetParam(), 60, 150);
  settings.mutation_probability = 0.1;
  const FrontSearch found = searchFront({space, goals, evaluator}, settings, {}, progress_);
  ASSERT_GT(found.front.size(), 40U);
  double above = 0.0;
  for (const Evaluation& one : found.front) {
    EXPECT_EQ(violationOf(goals, evaluator.responseNames(), one.responses), 0.0);
    const double x = one.responses[0];
    const double best = x < 2.0 / 3.0 ? (7.0 - 9.0 * x) / x : 1.0 / x;
    EXPECT_GE(one.responses[1], best - 1e-9);
    above += (one.responses[1] - best) / static_cast<double>(found.front.size());
  }
  EXPECT_LT(above, 0.01 * (9.0 - 1.0));
  EXPECT_NEAR(found.front.front().responses[0], 7.0 / 18.0, 0.05);
  EXPECT_NEAR(found.front.back().responses[0], 1.0, 0.01);
}

TEST_P(Nsga2Test, MaximisedObjectivesGrow) {
  ParallelEvaluator evaluator({"time_s", "error_mm3"}, [](const DesignPoint& point, Progress&) {
    return std::vector<double>{point[0], -point[0]};
  });
  const Goals goals{{{"time_s", Sense::Maximise, 1.0}}, {}};
  Nsga2Settings settings = nsga2SettingsOf(GetParam(), 20, 20);
  settings.mutation_probability = 0.3;
  settings.reference = {0.3};
  const FrontSearch found = searchFront({mixedSpace(), goals, evaluator}, settings, {}, progress_);
  EXPECT_NEAR(found.front.back().responses[0], 2.5, 1e-3);
  EXPECT_EQ(found.reference, std::vector<double>{0.3});
  EXPECT_NEAR(found.generations.back().hypervolume, 2.2, 1e-3);
}

TEST_P(Nsga2Test, BeginsWithGivenPointsAndCornersIfAsked) {
  CountingEvaluator evaluator;
  Nsga2Settings settings = nsga2SettingsOf(GetParam(), 20, 0);
  settings.first_points = {{0.4, 2.0, 0.2, 1.0}};
  settings.takes_corners = true;
  const FrontSearch found = search(evaluator, settings);
  ASSERT_EQ(found.evaluations.size(), 20U);
  EXPECT_EQ(found.evaluations[0].point, settings.first_points[0]);
  // Three ordered variables have eight corners.
  std::vector<DesignPoint> corners;
  for (std::size_t i = 1; i < 9; ++i) {
    DesignPoint point = found.evaluations[i].point;
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_TRUE(point[j] == lowOf(mixedSpace()[j]) || point[j] == highOf(mixedSpace()[j]));
    point.pop_back();
    corners.push_back(point);
  }
  EXPECT_EQ(corners[0], (DesignPoint{0.3, 1.0, 0.15}));
  EXPECT_EQ(corners[1], (DesignPoint{2.5, 4.0, 0.3}));
  std::sort(corners.begin(), corners.end());
  EXPECT_EQ(std::unique(corners.begin(), corners.end()), corners.end());
  settings.first_points = std::vector<DesignPoint>(30, DesignPoint{0.4, 2.0, 0.2, 1.0});
  EXPECT_EQ(search(evaluator, settings).evaluations.size(), 20U);
}

/// Populations of a few points lose some of the front from one generation to the next.
TEST_P(Nsga2Test, LosesNothingOfTheFrontAndItsHypervolumeNeverFalls) {
  EXPECT_TRUE(rc::check("small populations", [&](std::uint64_t seed) {
    CountingEvaluator evaluator;
    Nsga2Settings settings = nsga2SettingsOf(GetParam(), 4 + static_cast<int>(seed % 5), 12);
    settings.seed = static_cast<int>(seed % 100000);
    const FrontSearch found = search(evaluator, settings);
    // The area of n points is a sum of n rectangles, none negative. Both sides of one, their product and the
    // n - 1 sums round by half an epsilon each: the area by (n + 2) halves of its size, and that of the
    // generation before by as much.
    for (std::size_t i = 1; i < found.generations.size(); ++i) {
      const Generation& now = found.generations[i];
      const double rounding = (now.evaluations + 2) * std::numeric_limits<double>::epsilon();
      RC_ASSERT(now.hypervolume >= (1.0 - rounding) * found.generations[i - 1].hypervolume);
    }
    std::vector<Score> scores;
    for (const Evaluation& one : found.evaluations)
      scores.push_back(scoreOf(timeAndError(), evaluator.responseNames(), one));
    std::vector<DesignPoint> wanted;
    for (const std::size_t i : paretoFront(scores)) wanted.push_back(found.evaluations[i].point);
    std::vector<DesignPoint> front;
    for (const Evaluation& one : found.front) front.push_back(one.point);
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::sort(front.begin(), front.end());
    RC_ASSERT(front == wanted);
  }));
}

TEST_P(Nsga2Test, RefusesSettingsThatCannotBeUsed) {
  CountingEvaluator evaluator;
  const auto refusal = [&](const Nsga2Settings& settings) -> std::string {
    try {
      search(evaluator, settings);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(nsga2SettingsOf(GetParam(), 3, 1)).find("nsga2.population is '3'"), std::string::npos);
  Nsga2Settings settings;
  settings.crossover_share = settings.mutation_share = 0.0;
  EXPECT_NE(refusal(settings).find("make no new points"), std::string::npos);
  settings = {};
  settings.first_points = {{9.0, 2.0, 0.2, 1.0}};
  EXPECT_NE(refusal(settings).find("pitch_mm: 9"), std::string::npos);
  settings = {};
  settings.reference = {1.0};
  EXPECT_NE(refusal(settings).find("there are 2 objectives"), std::string::npos);
  EXPECT_EQ(evaluator.tried(), 0);
}

INSTANTIATE_TEST_SUITE_P(Variations, Nsga2Test, ::testing::Values(Variation::Blend, Variation::Sbx),
                         [](const auto& variation) {
                           return variation.param == Variation::Blend ? "Blend" : "Sbx";
                         });

}  // namespace
}  // namespace lamina
