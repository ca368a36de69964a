// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading and welding binary STL, and the check that a sound mesh pays before it is sliced; spheres of
// growing size.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace {

using namespace lamina;

/// A sphere of about this many triangles; twice as many go round as up.
Mesh sphere(std::int64_t triangles) {
  int segments = 8;
  while (std::int64_t{segments} * segments < triangles) segments += 2;
  return makePart("sphere", {{"segments", std::to_string(segments)}, {"radius_mm", "50"}});
}

void readStl(benchmark::State& state) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/sphere.stl";
  writeStl(path, sphere(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(readMesh(path));
  state.SetComplexityN(state.range(0));
}

void checkSoundMesh(benchmark::State& state) {
  const Mesh mesh = sphere(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(repairMesh(mesh));
  state.SetComplexityN(state.range(0));
}

BENCHMARK(readStl)
    ->RangeMultiplier(4)
    ->Range(16384, 1048576)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(checkSoundMesh)
    ->RangeMultiplier(4)
    ->Range(16384, 1048576)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

}  // namespace

BENCHMARK_MAIN();
