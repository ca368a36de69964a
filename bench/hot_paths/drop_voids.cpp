// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Finding and filling the voids of one layer of drops, on one thread: time over the number of drops, both
// detectors side by side. The layer is a square lattice in a closed contour, of which every fiftieth drop
// inside is missing; like any lattice it is the worst case of a Voronoi diagram, all of its vertices being of
// degree four.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/voids/drops/drop_filling.hpp"

namespace {

using namespace lamina;

constexpr double kDiameter = 0.4;       // mm
constexpr std::size_t kMissingOf = 50;  // drops, one of them
constexpr double kScatter = 0.05;       // of the diameter: how far drops of a real program lie off a lattice

enum class Cloud { Lattice, Scattered };

DropLayer squareLayer(std::size_t drops, Cloud cloud) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(drops)));
  DropLayer layer;
  layer.diameter_mm = kDiameter;
  for (int i = 0; i < side - 1; ++i) layer.drops.emplace_back(i, 0);
  for (int i = 0; i < side - 1; ++i) layer.drops.emplace_back(side - 1, i);
  for (int i = side - 1; i > 0; --i) layer.drops.emplace_back(i, side - 1);
  for (int i = side - 1; i > 0; --i) layer.drops.emplace_back(0, i);
  layer.chains.push_back({DropRole::Contour, 0, layer.drops.size()});
  Random random(1);
  for (int y = 1; y < side - 1; ++y)
    for (int x = 1; x < side - 1; ++x) {
      if (random.below(kMissingOf) == 0) continue;
      Point2 drop(x, y);
      if (cloud == Cloud::Scattered)
        drop += Point2(random.uniform(-kScatter, kScatter), random.uniform(-kScatter, kScatter));
      layer.drops.push_back(drop);
    }
  layer.chains.push_back({DropRole::Infill, layer.chains[0].end, layer.drops.size()});
  for (Point2& drop : layer.drops) drop *= kDiameter;
  return layer;
}

void detect(benchmark::State& state, VoidDetector detector, Cloud cloud) {
  const DropLayer layer = squareLayer(static_cast<std::size_t>(state.range(0)), cloud);
  const VoidSearch search{kDiameter, 0.8 * kDiameter};
  std::size_t points = 0;
  for (auto _ : state) {
    const auto found = findVoidPoints(detector, layer.drops, search);
    points = found.size();
    benchmark::DoNotOptimize(found.data());
  }
  state.SetComplexityN(state.range(0));
  state.counters["points"] = static_cast<double>(points);
}

void fill(benchmark::State& state, VoidDetector detector, Cloud cloud) {
  const DropLayer layer = squareLayer(static_cast<std::size_t>(state.range(0)), cloud);
  DropVoidSettings settings;
  settings.detector = detector;
  std::size_t added = 0;
  for (auto _ : state) added = newDrops(fillDropVoids(layer, settings)).size();
  state.SetComplexityN(state.range(0));
  state.counters["new_drops"] = static_cast<double>(added);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond)->Complexity();
}

BENCHMARK_CAPTURE(detect, voronoi_lattice, VoidDetector::Voronoi, Cloud::Lattice)->Apply(sizes);
BENCHMARK_CAPTURE(detect, neighbours_lattice, VoidDetector::Neighbours, Cloud::Lattice)->Apply(sizes);
BENCHMARK_CAPTURE(detect, voronoi_scattered, VoidDetector::Voronoi, Cloud::Scattered)->Apply(sizes);
BENCHMARK_CAPTURE(detect, neighbours_scattered, VoidDetector::Neighbours, Cloud::Scattered)->Apply(sizes);
BENCHMARK_CAPTURE(fill, voronoi_lattice, VoidDetector::Voronoi, Cloud::Lattice)->Apply(sizes);
BENCHMARK_CAPTURE(fill, neighbours_lattice, VoidDetector::Neighbours, Cloud::Lattice)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
