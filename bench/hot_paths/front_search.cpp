// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problems/dtlz.hpp>
#include <pagmo/problems/zdt.hpp>

#include "lamina/optimisation/nsga2.hpp"
#include "optimisation/pagmo_problem.hpp"

namespace {

using namespace lamina;

/// The same search by both, with the same operators.
struct Race {
  pagmo::problem problem;
  int population;
  int generations;
};

Race zdt1() { return {pagmo::problem(pagmo::zdt(1, 30)), 100, 250}; }
Race dtlz2() { return {pagmo::problem(pagmo::dtlz(2, 12, 3)), 200, 300}; }

/// Mean distance of points from the true front.
double distanceFrom(const pagmo::problem& problem, const std::vector<std::vector<double>>& points) {
  double sum = 0.0;
  for (const auto& point : points) {
    if (const auto* zdt = problem.extract<pagmo::zdt>()) sum += zdt->p_distance(point);
    if (const auto* dtlz = problem.extract<pagmo::dtlz>()) sum += dtlz->p_distance(point);
  }
  return sum / static_cast<double>(points.size());
}

void ours(benchmark::State& state, const Race& race) {
  const PagmoProblem problem(race.problem);
  Nsga2Settings settings;
  settings.variation = Variation::Sbx;
  settings.population = race.population;
  settings.generations = race.generations;
  double distance = 0.0;
  int searches = 0;
  for (auto _ : state) {
    settings.seed = ++searches;
    NoProgress progress;
    std::vector<std::vector<double>> points;
    for (const Evaluation& one : searchFront(problem.search(), settings, {}, progress).front)
      points.push_back(one.point);
    distance += distanceFrom(race.problem, points);
  }
  state.counters["p_distance"] = distance / searches;
}

void pagmos(benchmark::State& state, const Race& race) {
  double distance = 0.0;
  unsigned searches = 0;
  for (auto _ : state) {
    const unsigned seed = ++searches;
    const pagmo::nsga2 nsga2(static_cast<unsigned>(race.generations), 0.95, 10.0, 0.01, 50.0, seed);
    const pagmo::population first(race.problem, static_cast<std::size_t>(race.population), seed);
    distance += distanceFrom(race.problem, nsga2.evolve(first).get_x());
  }
  state.counters["p_distance"] = distance / searches;
}

}  // namespace

BENCHMARK_CAPTURE(ours, zdt1_30_100x250, zdt1())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pagmos, zdt1_30_100x250, zdt1())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, dtlz2_3_200x300, dtlz2())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pagmos, dtlz2_3_200x300, dtlz2())->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
