// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/surrogate_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/experiment_table.hpp"
#include "lamina/optimisation/response_surrogates.hpp"
#include "optimisation/test_problems.hpp"

namespace lamina {
namespace {

/// Interpolates along one variable between the nearest samples on either side; less sure the farther they
/// are.
class LineSurrogate final : public Surrogate {
 public:
  LineSurrogate(const std::vector<DesignPoint>& points, const std::vector<double>& values) {
    if (points.size() < 2) throw InvalidInput("too few");
    for (std::size_t i = 0; i < points.size(); ++i) samples_.emplace_back(points[i][0], values[i]);
    std::sort(samples_.begin(), samples_.end());
  }

  Prediction at(const DesignPoint& point) const override {
    std::size_t i = 1;
    while (i + 1 < samples_.size() && samples_[i].first < point[0]) ++i;
    const auto& [a, fa] = samples_[i - 1];
    const auto& [b, fb] = samples_[i];
    const double share = (point[0] - a) / (b - a);
    return {fa + share * (fb - fa), std::abs((point[0] - a) * (b - point[0]))};
  }
  std::string description() const override {
    return "line through " + std::to_string(samples_.size()) + " samples";
  }

 private:
  std::vector<std::pair<double, double>> samples_;
};

std::unique_ptr<Surrogate> fitLine(const DesignSpace&, const std::vector<DesignPoint>& points,
                                   const std::vector<double>& values) {
  return std::make_unique<LineSurrogate>(points, values);
}

const std::vector<std::string> kSurrogateSearchNames = {"cost", "strength"};

/// Least cost at x = 0.5; strong enough below 0.8.
std::vector<double> measured(const DesignPoint& point, Progress&) {
  return {10.0 + std::pow(point[0] - 0.5, 2.0), 1.8 - point[0]};
}

Goals goals() { return {{{"cost", Sense::Minimise, 1.0}}, {{"strength", 1.0, 9.0}}}; }

SurrogateSearchSettings settings() {
  SurrogateSearchSettings settings;
  settings.design.kind = DesignKind::FullFactorial;
  settings.design.levels = "3";
  settings.genetic.individuals = 20;
  settings.genetic.generations = 20;
  return settings;
}

SurrogateSearch searched(Evaluator& evaluator, const SurrogateSearchSettings& settings,
                         std::vector<Evaluation> samples = {}) {
  NoProgress progress;
  return searchBySurrogate({unitSpace(1), goals(), evaluator}, {fitLine, std::move(samples)}, settings, {},
                           progress);
}

TEST(SurrogateSearchTest, TriesTheDesignThenWhatItProposesAndKeepsTheBest) {
  ParallelEvaluator evaluator(kSurrogateSearchNames, measured);
  SurrogateSearchSettings chosen = settings();
  chosen.proposal = Proposal::ExpectedImprovement;
  chosen.most_iterations = 12;
  chosen.least_improvement_percent = 0.0;
  std::vector<std::size_t> reported;
  NoProgress progress;
  const SurrogateSearch search = searchBySurrogate(
      {unitSpace(1), goals(), evaluator}, {fitLine, {}}, chosen,
      [&](const SurrogateIteration& iteration) { reported.push_back(iteration.index); }, progress);
  EXPECT_EQ(search.design_size, 3U);
  EXPECT_EQ(search.evaluations.size(), 3U + 12U);
  EXPECT_EQ(reported.size(), 12U);
  EXPECT_EQ(search.end, SurrogateEnd::Iterations);
  ASSERT_TRUE(search.best);
  EXPECT_NEAR(search.evaluations[*search.best].point[0], 0.5, 0.05);
  EXPECT_GT(search.iterations[0].expected_improvement, 0.0);
  EXPECT_EQ(search.iterations[1].surrogates[1], "line through 4 samples");
}

TEST(SurrogateSearchTest, AcceptsWhatWasPredictedWellAfterTheLeastNumberOfIterations) {
  ParallelEvaluator evaluator(kSurrogateSearchNames, measured);
  const SurrogateSearch search =
      searched(evaluator, settings(),
               {{{-1.0}, {12.25, 2.8}, ""}, {{0.6}, {10.01, 1.2}, ""}, {{1.0}, {9.9, 0.8}, ""}});
  // The line sinks to 1.0; strength ends it at 0.8.
  const SurrogateIteration& first = search.iterations.front();
  EXPECT_NEAR(first.proposed[0], 0.8, 1e-4);
  EXPECT_EQ(first.predicted_violation, 0.0);
  EXPECT_NEAR(first.predictions[0].value, 9.955, 1e-3);
  EXPECT_NEAR(first.mape_percent, 100.0 * (10.09 - 9.955) / 10.09 / 2.0, 0.01);
  EXPECT_TRUE(first.is_accepted && first.is_feasible && !first.is_sample);
  EXPECT_NEAR(first.predicted_fitness, 9.955 / ((12.25 + 10.01 + 9.9) / 3.0), 1e-4);
  // Four proposals are asked for; the second one is where the first was tried.
  EXPECT_EQ(search.end, SurrogateEnd::Sampled);
  EXPECT_EQ(search.iterations.size(), 2U);
  SurrogateSearchSettings one = settings();
  one.iterations = 1;
  const SurrogateSearch once = searched(
      evaluator, one, {{{-1.0}, {12.25, 2.8}, ""}, {{0.6}, {10.01, 1.2}, ""}, {{1.0}, {9.9, 0.8}, ""}});
  EXPECT_EQ(once.end, SurrogateEnd::Accepted);
  EXPECT_EQ(once.iterations.size(), 1U);
}

TEST(SurrogateSearchTest, EndsAtAPointThatIsASampleAlready) {
  ParallelEvaluator evaluator(kSurrogateSearchNames, measured);
  const SurrogateSearch search =
      searched(evaluator, settings(), {{{-1.0}, {12.0, 2.0}, ""}, {{1.0}, {8.0, 2.0}, ""}});
  EXPECT_EQ(search.end, SurrogateEnd::Sampled);
  ASSERT_EQ(search.iterations.size(), 1U);
  EXPECT_TRUE(search.iterations[0].is_sample && !search.iterations[0].is_accepted);
  EXPECT_EQ(search.iterations[0].measured.responses, (std::vector<double>{8.0, 2.0}));
  EXPECT_EQ(search.evaluations.size(), 2U);
  EXPECT_EQ(search.best, 1U);
}

TEST(SurrogateSearchTest, RefusesMoreIterationsThanItMayDo) {
  ParallelEvaluator evaluator(kSurrogateSearchNames, measured);
  SurrogateSearchSettings chosen = settings();
  chosen.iterations = chosen.most_iterations + 1;
  EXPECT_THROW(searched(evaluator, chosen, {}), InvalidConfig);
}

TEST(SurrogateSearchTest, WaitsForWhatIsNotInTheTable) {
  TableEvaluator evaluator(unitSpace(1), kSurrogateSearchNames, {{{0.79}, {9.97, 1.05}, ""}}, 0.01);
  SurrogateSearchSettings chosen = settings();
  chosen.failed_proposal = FailedProposal::Stop;
  const SurrogateSearch search = searched(
      evaluator, chosen, {{{-1.0}, {12.25, 2.8}, ""}, {{0.6}, {10.01, 1.2}, ""}, {{1.0}, {9.9, 0.8}, ""}});
  EXPECT_EQ(search.end, SurrogateEnd::NotMeasured);
  ASSERT_EQ(search.iterations.size(), 2U);
  EXPECT_EQ(search.iterations[0].measured.point, (DesignPoint{0.79}));
  EXPECT_NE(search.iterations[1].measured.error.find("not in the table; measure a "), std::string::npos);
  EXPECT_TRUE(std::isnan(search.iterations[1].mape_percent));
  EXPECT_FALSE(search.iterations[1].is_accepted);
  EXPECT_FALSE(search.iterations[1].predictions.empty());
}

TEST(SurrogateSearchTest, KeepsAwayFromPointsThatCannotBeTried) {
  std::size_t failures = 0;
  ParallelEvaluator evaluator(kSurrogateSearchNames, [&](const DesignPoint& point, Progress& progress) {
    if (std::abs(point[0] - 0.8) < 0.01) {
      ++failures;
      throw InvalidInput("jammed");
    }
    return measured(point, progress);
  });
  SurrogateSearchSettings chosen = settings();
  chosen.nearness = 0.02;
  const SurrogateSearch search = searched(
      evaluator, chosen, {{{-1.0}, {12.25, 2.8}, ""}, {{0.6}, {10.01, 1.2}, ""}, {{1.0}, {9.9, 0.8}, ""}});
  EXPECT_EQ(failures, 1U);
  EXPECT_EQ(search.iterations[0].measured.error, "jammed");
  EXPECT_EQ(search.evaluations[3].error, "jammed");
  ASSERT_GE(search.iterations.size(), 2U);
  EXPECT_TRUE(isEvaluated(search.iterations[1].measured));
}

TEST(SurrogateSearchTest, PredictsWhatSamplesLackFromThoseThatHaveIt) {
  const std::vector<Evaluation> samples = {
      {{-1.0}, {12.0, NAN}, ""}, {{0.0}, {10.0, 1.0}, ""}, {{1.0}, {8.0, 2.0}, ""}, {{0.5}, {}, "broke"}};
  const ResponseSurrogates surrogates(unitSpace(1), kSurrogateSearchNames, samples, fitLine);
  const std::vector<Evaluation> filled = withMissingPredicted(samples, surrogates);
  EXPECT_EQ(filled[0].responses, (std::vector<double>{12.0, 0.0}));
  EXPECT_EQ(filled[1].responses, samples[1].responses);
  EXPECT_TRUE(filled[3].responses.empty());
  EXPECT_EQ(surrogates.descriptions(),
            (std::vector<std::string>{"line through 3 samples", "line through 2 samples"}));
  try {
    static_cast<void>(
        ResponseSurrogates(unitSpace(1), kSurrogateSearchNames, {samples[0], samples[1]}, fitLine));
    ADD_FAILURE() << "one sample is enough";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "response strength: too few");
  }
}

TEST(SurrogateSearchTest, RefusesSamplesOfAnotherSpace) {
  ParallelEvaluator evaluator(kSurrogateSearchNames, measured);
  EXPECT_THROW(searched(evaluator, settings(), {{{5.0}, {1.0, 1.0}, ""}}), InvalidInput);
  EXPECT_THROW(searched(evaluator, settings(), {{{0.5}, {1.0}, ""}}), InvalidInput);
}

}  // namespace
}  // namespace lamina
