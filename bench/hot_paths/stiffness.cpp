// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness.hpp"

#include <benchmark/benchmark.h>

#include "lamina/base/available_memory.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/scaffold/scaffold.hpp"
#include "support/voxel_shapes.hpp"

namespace {

void measure(benchmark::State& state, const lamina::VoxelGrid& grid) {
  lamina::NoProgress progress;
  lamina::StiffnessResult result;
  for (auto _ : state) result = solveStiffness(grid, {}, progress);
  state.counters["elements"] = static_cast<double>(result.model.lattice.elementCount());
  state.counters["iterations"] = result.iterations;
  state.counters["modulus_mpa"] = result.modulus_mpa;
  state.counters["peak_mb"] = lamina::peakMemory() / 1e6;
}

/// Voxels in micrometres, of the usual sinusoidal scaffold.
void scaffold(benchmark::State& state) {
  lamina::ScaffoldSettings settings = lamina::scaffoldDefaults("sinusoidal");
  lamina::DepositionSettings deposition;
  deposition.voxel_mm = static_cast<double>(state.range(0)) / 1000.0;
  lamina::NoProgress progress;
  measure(state, depositedVoxels(makeScaffold("sinusoidal", settings), deposition, progress).grid);
}
BENCHMARK(scaffold)
    ->Arg(150)
    ->Arg(100)
    ->Arg(75)
    ->Arg(50)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime();

/// Elements along a side of the cube.
void gyroid(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  measure(state, lamina::test::gyroid(side, 9.0 / side));
}
BENCHMARK(gyroid)->Arg(40)->Arg(80)->Arg(160)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
