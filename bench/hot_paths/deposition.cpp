// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Laying beads into voxels, one thread: metres of path per second, bytes a voxel of the box. Sparse is a
// lattice of every fourth line, solid fills the layers, packed too tight extrudes a tenth more than there is
// room for, so that material has to go far.
#include <benchmark/benchmark.h>

#include <cmath>

#include "lamina/deposition/toolpath_deposit.hpp"

namespace lamina {
namespace {

constexpr double kSide = 20.0;  // mm
constexpr int kLayers = 10;
const Bead kBead{0.48, 0.3};

/// Layers of lines, along x and along y in turn.
/// @param pitch  of the lines, in plan widths of the bead
Toolpath lattice(double pitch, double flow) {
  Toolpath toolpath;
  for (int l = 0; l < kLayers; ++l) {
    ToolpathLayer layer;
    layer.height_mm = kBead.height_mm;
    layer.z_mm = (l + 1) * kBead.height_mm;
    for (double across = 0.0; across < kSide; across += pitch * planWidth(kBead)) {
      Path path;
      path.points = {Point3(0, across, layer.z_mm), Point3(kSide, across, layer.z_mm)};
      if (l % 2 == 1) path.points = {Point3(across, 0, layer.z_mm), Point3(across, kSide, layer.z_mm)};
      path.orientation = nozzleDown();
      path.bead = beadOfArea(flow * crossSection(kBead), kBead.height_mm);
      layer.paths.push_back(path);
    }
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

void lay(benchmark::State& state, double pitch, double flow) {
  const Toolpath toolpath = lattice(pitch, flow);
  DepositionSettings settings;
  settings.voxel_mm = static_cast<double>(state.range(0)) / 1e3;
  NoProgress progress;
  double bytes_per_voxel = 0.0;
  for (auto _ : state) {
    const ToolpathDeposit deposit = depositedVoxels(toolpath, settings, progress);
    const VoxelRange solid = deposit.grid.solidRange();
    const double voxels = double(solid.high[0] - solid.low[0]) * double(solid.high[1] - solid.low[1]) *
                          double(solid.high[2] - solid.low[2]);
    bytes_per_voxel = static_cast<double>(deposit.grid.bytes()) / voxels;
  }
  state.counters["path_m_per_s"] =
      benchmark::Counter(totals(toolpath).deposition_mm / 1e3, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bits_per_voxel"] = 8.0 * bytes_per_voxel;
}

void laySparse(benchmark::State& state) { lay(state, 4.0, 1.0); }
void laySolid(benchmark::State& state) { lay(state, 1.0, 1.0); }
void layPackedTooTight(benchmark::State& state) { lay(state, 1.0, 1.1); }
BENCHMARK(laySparse)->ArgName("voxel_um")->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(laySolid)->ArgName("voxel_um")->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(layPackedTooTight)->ArgName("voxel_um")->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
