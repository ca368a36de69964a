// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/stiffness_job.hpp"

#include <chrono>
#include <cmath>

#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/geometry/voxel/voxelised_mesh.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/part/part_mesh.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/stiffness/calculix_deck.hpp"
#include "lamina/stiffness/stiffness_memory.hpp"
#include "lamina/stiffness/stiffness_vtk.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

using SteadyTime = std::chrono::steady_clock;

/// Refuses, before any voxel is filled, what needs more memory to be solved than there is.
void requireMemoryFor(double volume_mm3, const JobSettings& settings) {
  const double voxel_mm = settings.deposition.voxel_mm;
  const double voxels = volume_mm3 / (voxel_mm * voxel_mm * voxel_mm);
  requireMemory(stiffnessBytes(voxels, voxels), settings.stiffness.memory_mb, voxel_mm);
}

VoxelGrid voxelsAsDrawn(const StiffnessJob& job, Progress& progress) {
  const Mesh mesh = partMesh(job.input, job.settings.input);
  requireMemoryFor(std::abs(volume(mesh)), job.settings);
  return voxelisedMesh(mesh, job.settings.deposition.voxel_mm, progress);
}

VoxelGrid voxelsAsDeposited(const Toolpath& toolpath, const JobSettings& settings, Progress& progress) {
  requireMemoryFor(totals(toolpath).deposited_mm3, settings);
  return depositedVoxels(toolpath, settings.deposition, progress).grid;
}

VoxelGrid voxelsOf(const StiffnessJob& job, Progress& progress) {
  const JobSettings& settings = job.settings;
  const bool is_part = !isProgramFile(job.input) && !isToolpathFile(job.input);
  if (is_part && job.solid == PartSolid::AsDrawn) return voxelsAsDrawn(job, progress);
  if (!is_part) {
    const Toolpath toolpath = readToolpathFile(job.input, settings.program, settings.machine);
    return voxelsAsDeposited(toolpath, settings, progress);
  }
  const SlicedPart sliced = runSliceJob({job.input, "", settings}, progress);
  return voxelsAsDeposited(placed(sliced.toolpath, sliced.bed_from_part), settings, progress);
}

}  // namespace

LoadedPart runStiffnessJob(const StiffnessJob& job, Progress& progress) {
  requireSuffix(job.output, {".vtk"});
  requireSuffix(job.deck, {".inp"});
  requireApart({job.output, job.deck}, {job.input});
  validate(job.settings);
  const VoxelGrid grid = voxelsOf(job, progress);
  const SteadyTime::time_point start = SteadyTime::now();
  LoadedPart part;
  part.thickness = strandThicknessOf(grid);
  part.result = solveStiffness(grid, job.settings.stiffness, progress);
  part.solve_s = std::chrono::duration<double>(SteadyTime::now() - start).count();
  if (!job.output.empty()) writeVtk(part.result, job.output);
  if (!job.deck.empty()) writeCalculixDeck(part.result, job.settings.stiffness.material, job.deck);
  return part;
}

}  // namespace lamina
