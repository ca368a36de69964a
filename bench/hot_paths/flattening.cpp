// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Geodesic distances, flattening by each method and cutting into charts, on one thread: time over triangles.
#include "lamina/parameterization/flattening.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

#include "lamina/parameterization/geodesic.hpp"
#include "lamina/parameterization/layer_charts.hpp"

namespace {

using namespace lamina;

/// A square of 60 mm of about `triangles` triangles, with `height` giving z of x and y from 0 to 1.
template <class Height>
LayerSurface square(std::int64_t triangles, const Height& height) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2.0));
  LayerSurface layer;
  for (std::uint32_t j = 0; j <= side; ++j)
    for (std::uint32_t i = 0; i <= side; ++i) {
      const double x = double(i) / side;
      const double y = double(j) / side;
      layer.middle.vertices.emplace_back(60.0 * x, 60.0 * y, height(x, y));
    }
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t a = j * (side + 1) + i;
      layer.middle.triangles.push_back({a, a + 1, a + side + 2});
      layer.middle.triangles.push_back({a, a + side + 2, a + side + 1});
    }
  layer.tip = layer.middle.vertices;
  layer.normal.assign(layer.tip.size(), Point3::UnitZ());
  layer.height_mm.assign(layer.tip.size(), 0.2);
  return layer;
}

LayerSurface waves(std::int64_t triangles) {
  return square(triangles, [](double x, double y) { return 5.0 * std::sin(7.0 * x) * std::cos(5.0 * y); });
}

/// The top of an ellipsoid, steep at the corners, which does not lie flat in one piece.
LayerSurface dome(std::int64_t triangles) {
  return square(triangles, [](double x, double y) {
    return 40.0 * std::sqrt(2.1 - std::pow(2.0 * x - 1.0, 2) - std::pow(2.0 * y - 1.0, 2));
  });
}

void geodesics(benchmark::State& state) {
  const LayerSurface layer = waves(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(GeodesicDistances(layer.middle).from(0));
  state.SetComplexityN(state.range(0));
}

void flattening(benchmark::State& state, FlatteningMethod method) {
  const LayerSurface layer = waves(state.range(0));
  FlatteningSettings settings;
  settings.method = method;
  for (auto _ : state) benchmark::DoNotOptimize(flatten(layer.middle, settings));
  state.SetComplexityN(state.range(0));
}

void arap(benchmark::State& state) { flattening(state, FlatteningMethod::Arap); }
void byMds(benchmark::State& state) { flattening(state, FlatteningMethod::Mds); }
void byStress(benchmark::State& state) { flattening(state, FlatteningMethod::Stress); }

void chartsOfDome(benchmark::State& state) {
  const LayerSurface layer = dome(state.range(0));
  std::size_t charts = 0;
  for (auto _ : state) charts = layerCharts(layer, {}).size();
  state.counters["charts"] = static_cast<double>(charts);
  state.SetComplexityN(state.range(0));
}

BENCHMARK(geodesics)
    ->Arg(5000)
    ->Arg(50000)
    ->Arg(500000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(arap)->Arg(5000)->Arg(50000)->Arg(500000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(byMds)->Arg(5000)->Arg(50000)->Arg(500000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(byStress)->Arg(5000)->Arg(50000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(chartsOfDome)->Arg(5000)->Arg(50000)->Arg(500000)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace

BENCHMARK_MAIN();
