// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/optimisation/surrogate_search.hpp"

namespace lamina {
namespace {

DesignSpace cube() {
  DesignSpace space;
  for (const char* name : {"x", "y", "z", "u"})
    space.push_back({name, VariableKind::Continuous, 0.0, 1.0, {}, {}});
  return space;
}

/// Four smooth responses of four variables.
std::vector<double> responsesAt(const DesignPoint& point) {
  std::vector<double> responses;
  for (int k = 1; k <= 4; ++k)
    responses.push_back(10.0 + std::sin(k * point[0]) + point[1] * std::cos(2.0 * point[2]) +
                        0.3 * k * point[3] * point[3]);
  return responses;
}

std::vector<Evaluation> samples(std::size_t count) {
  std::vector<Evaluation> made;
  for (const DesignPoint& point : latinHypercube(cube(), count, 1))
    made.push_back({point, responsesAt(point), ""});
  return made;
}

void fitOne(benchmark::State& state, Correlation correlation) {
  std::vector<DesignPoint> points;
  std::vector<double> values;
  for (const Evaluation& sample : samples(static_cast<std::size_t>(state.range(0)))) {
    points.push_back(sample.point);
    values.push_back(sample.responses[0]);
  }
  KrigingSettings settings;
  settings.correlation = correlation;
  for (auto _ : state) benchmark::DoNotOptimize(krigingFit(settings)(cube(), points, values));
}

/// Fits four responses, searches 10 000 points of the surrogates and tries the best one.
void proposeOne(benchmark::State& state, Proposal proposal) {
  const std::vector<Evaluation> known = samples(static_cast<std::size_t>(state.range(0)));
  const Goals goals{{{"a", Sense::Minimise, 0.5}, {"b", Sense::Minimise, 0.5}, {"d", Sense::Minimise, 0.0}},
                    {{"c", 9.5, 12.0}}};
  SurrogateSearchSettings settings;
  settings.proposal = proposal;
  settings.iterations = settings.most_iterations = 1;
  for (auto _ : state) {
    ParallelEvaluator evaluator({"a", "b", "c", "d"},
                                [](const DesignPoint& point, Progress&) { return responsesAt(point); });
    NoProgress progress;
    benchmark::DoNotOptimize(searchBySurrogate(
        {cube(), goals, evaluator}, {krigingFit(KrigingSettings{}), known}, settings, {}, progress));
  }
}

BENCHMARK_CAPTURE(fitOne, exponential, Correlation::Exponential)
    ->Arg(50)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fitOne, matern_5_2, Correlation::Matern52)
    ->Arg(50)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proposeOne, predicted, Proposal::Predicted)
    ->Arg(50)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proposeOne, expected_improvement, Proposal::ExpectedImprovement)
    ->Arg(50)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
