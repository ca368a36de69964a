// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/deposit_job.hpp"

#include <utility>

#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/voxel/isosurface.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/pores/voxel_surface.hpp"

namespace lamina {
namespace {

/// Open part of the box around all that is solid.
double porosityOf(const VoxelGrid& grid, std::int64_t solid) {
  if (solid == 0) return 0.0;
  const VoxelRange box = grid.solidRange();
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) voxels *= box.high[axis] - box.low[axis];
  return 1.0 - static_cast<double>(solid) / voxels;
}

}  // namespace

DepositSummary summaryOf(const VoxelGrid& grid, const DepositTotals& totals, double highest_mm) {
  DepositSummary summary;
  summary.totals = totals;
  summary.voxel_mm = grid.frame().voxel_mm;
  summary.voxels = grid.solidCount();
  summary.porosity = porosityOf(grid, summary.voxels);
  summary.surface_mm2 = voxelFaceArea(grid);
  summary.highest_mm = highest_mm;
  return summary;
}

DepositedPart runDepositJob(const DepositJob& job, Progress& progress) {
  static const std::string kStage = "surface";
  requireSuffix(job.output, {".stl"});
  requireApart({job.output}, {job.source});
  ToolpathDeposit deposit = depositedVoxels(job.toolpath, job.settings, progress);
  progress.report(kStage, 0.0);
  const DepositSummary summary = summaryOf(deposit.grid, deposit.totals, deposit.highest_mm);
  throwIfCancelled(progress, kStage);
  if (!job.output.empty()) {
    const Mesh surface = isosurface(deposit.grid);
    throwIfCancelled(progress, kStage);
    writeStl(job.output, surface);
  }
  progress.report(kStage, 1.0);
  return {std::move(deposit.grid), summary};
}

}  // namespace lamina
