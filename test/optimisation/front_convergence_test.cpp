// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problems/dtlz.hpp>
#include <pagmo/problems/zdt.hpp>
#include <pagmo/utils/multi_objective.hpp>

#include "lamina/base/random.hpp"
#include "lamina/optimisation/nsga2.hpp"
#include "lamina/optimisation/pareto.hpp"
#include "pagmo_problem.hpp"

namespace lamina {
namespace {

// Ours may end a quarter farther from the true front than pagmo's. All seeds are fixed, so every run gives
// the same figures and no margin for chance is added.
constexpr double kDistanceRatio = 1.25;

/// How good fronts are, in the middle of several seeds.
struct Quality {
  double distance = 0.0;  ///< mean distance of points from the true front
  double volume = 0.0;    ///< hypervolume
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Quality middleOf(const std::vector<Quality>& searches) {
  std::vector<double> distances;
  std::vector<double> volumes;
  for (const Quality& one : searches) {
    distances.push_back(one.distance);
    volumes.push_back(one.volume);
  }
  return {median(distances), median(volumes)};
}

Nsga2Settings settingsOf(Variation variation, int population, int generations) {
  Nsga2Settings settings;
  settings.variation = variation;
  settings.population = population;
  settings.generations = generations;
  return settings;
}

template <class Test>
Quality ours(const Test& test, Nsga2Settings settings, int seeds) {
  const PagmoProblem problem{pagmo::problem(test)};
  const std::vector<double> reference(pagmo::problem(test).get_nobj(), 1.1);
  std::vector<Quality> searches;
  for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
    NoProgress progress;
    const FrontSearch found = searchFront(problem.search(), settings, {}, progress);
    double distance = 0.0;
    std::vector<std::vector<double>> costs;
    // As pagmo's, of the population; the front also holds what older points nothing dominates.
    const std::vector<Evaluation>& front = found.generations.back().front;
    for (const Evaluation& one : front) {
      costs.push_back(one.responses);
      distance += test.p_distance(one.point) / static_cast<double>(front.size());
    }
    searches.push_back({distance, hypervolume(costs, reference)});
  }
  return middleOf(searches);
}

template <class Test>
Quality pagmos(const Test& test, const Nsga2Settings& settings, int seeds) {
  const pagmo::problem problem(test);
  const std::vector<double> reference(problem.get_nobj(), 1.1);
  std::vector<Quality> searches;
  for (int seed = 1; seed <= seeds; ++seed) {
    const pagmo::nsga2 nsga2(static_cast<unsigned>(settings.generations), settings.crossover_probability,
                             settings.crossover_index, settings.mutation_probability, settings.mutation_index,
                             static_cast<unsigned>(seed));
    const pagmo::population first(problem, static_cast<std::size_t>(settings.population),
                                  static_cast<unsigned>(seed));
    const pagmo::population last = nsga2.evolve(first);
    searches.push_back({test.p_distance(last), hypervolume(last.get_f(), reference)});
  }
  return middleOf(searches);
}

/// Searches both ways from as many seeds. The same seed gives other numbers to the two, and single searches
/// differ by 40 % of their distance: of Dtlz2, medians of 9 differ by a third, those of 80 by 6 %.
/// @param least_volume  hypervolume of ours, of pagmo's
template <class Problem>
void expectAsByPagmo(const Problem& problem, const Nsga2Settings& settings, int seeds, double least_volume) {
  const Quality our = ours(problem, settings, seeds);
  const Quality their = pagmos(problem, settings, seeds);
  testing::Test::RecordProperty("our_distance", std::to_string(our.distance));
  testing::Test::RecordProperty("their_distance", std::to_string(their.distance));
  EXPECT_LT(our.distance, kDistanceRatio * their.distance);
  EXPECT_GT(our.volume, least_volume * their.volume);
}

TEST(FrontConvergenceTest, Zdt1WithThirtyVariablesIsSolvedAsByPagmo) {
  expectAsByPagmo(pagmo::zdt(1, 30), settingsOf(Variation::Sbx, 100, 250), 15, 0.999);
}

TEST(FrontConvergenceTest, Dtlz2WithThreeObjectivesIsSolvedAsByPagmo) {
  expectAsByPagmo(pagmo::dtlz(2, 12, 3), settingsOf(Variation::Sbx, 100, 75), 80, 0.98);
}

TEST(FrontConvergenceTest, TheSourcesVariationSolvesZdt1WithFiveVariables) {
  const pagmo::zdt test(1, 5);
  Nsga2Settings settings;
  const Quality twenty = ours(test, settings, 5);
  settings.generations = 100;
  const Quality hundred = ours(test, settings, 5);
  RecordProperty("distance_20", std::to_string(twenty.distance));
  RecordProperty("distance_100", std::to_string(hundred.distance));
  EXPECT_GT(hundred.volume, twenty.volume);
  EXPECT_LT(hundred.distance, 0.01);
  // The whole front dominates 1.21 - 1/3 of the reference's box.
  EXPECT_GT(hundred.volume, 0.98 * (1.21 - 1.0 / 3.0));
}

TEST(FrontConvergenceTest, FrontsAreThoseOfPagmo) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Score> scores;
    std::vector<std::vector<double>> costs;
    const std::size_t objectives = 1 + random.below(4);
    for (std::uint64_t i = 0; i < 2 + random.below(60); ++i) {
      costs.emplace_back();
      for (std::size_t j = 0; j < objectives; ++j)
        costs.back().push_back(static_cast<double>(random.below(trial % 2 == 0 ? 5 : 1000)));
      scores.push_back({costs.back(), 0.0});
    }
    if (costs.size() < 2) continue;
    auto expected = std::get<0>(pagmo::fast_non_dominated_sorting(costs));
    for (auto& front : expected) std::sort(front.begin(), front.end());
    EXPECT_EQ(frontsOf(scores), expected) << trial;
  }
}

}  // namespace
}  // namespace lamina
