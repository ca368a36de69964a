// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// One evaluation of a study: a box of 20 x 40 x 20 mm in 100 layers of concentric loops, about 200 m of path,
// sliced in memory and measured. Without its metrics, with the surface, and on one thread.
#include <benchmark/benchmark.h>

#include <string>

#include "lamina/base/parallel.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/metrics_job.hpp"

namespace lamina {
namespace {

SliceMeasurement orthohedron() {
  const JobSettings settings = loadJobSettings("", {{"walls.count", "0"},
                                                    {"infill.strategy", "contour"},
                                                    {"infill.density", "1"},
                                                    {"slicing.layer_height_mm", "0.2"},
                                                    {"slicing.first_layer_height_mm", "0.2"},
                                                    {"skirt.count", "0"}});
  const ScratchFolder folder;
  const std::string file = folder.path() + "/orthohedron.stl";
  writeStl(file, makePart("box", {{"x_mm", "20"}, {"y_mm", "40"}, {"z_mm", "20"}}));
  return SliceMeasurement({file, "", settings});
}

void evaluate(benchmark::State& state, const std::vector<std::string>& metrics) {
  const SliceMeasurement measurement = orthohedron();
  NoProgress nobody;
  std::vector<double> values;
  for (auto _ : state) values = measurement.measure({}, metrics, nobody);
  for (std::size_t m = 0; m < metrics.size(); ++m) state.counters[metrics[m]] = values[m];
}

void slicing(benchmark::State& state) { evaluate(state, {"material_mm", "travel_mm"}); }

void slicingAndSurface(benchmark::State& state) {
  evaluate(state, {"under_fill_mm2", "material_mm", "volume_error_mm3"});
}

void onOneThread(benchmark::State& state) {
  const ThreadLimit limit(1);
  evaluate(state, {"under_fill_mm2", "material_mm", "volume_error_mm3"});
}

BENCHMARK(slicing)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(slicingAndSurface)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(onOneThread)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
