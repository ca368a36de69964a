// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/solid_voxels.hpp"

#include <cmath>

#include "job/part_source.hpp"
#include "lamina/geometry/voxelised_mesh.hpp"
#include "lamina/stiffness/stiffness_memory.hpp"

namespace lamina {

VoxelGrid solidVoxels(const std::string& part, const JobSettings& settings, Progress& progress) {
  const Mesh mesh = readPart(part, settings.input).mesh;
  const double voxel_mm = settings.deposition.voxel_mm;
  const double voxels = std::abs(volume(mesh)) / (voxel_mm * voxel_mm * voxel_mm);
  requireMemory(stiffnessBytes(voxels, voxels), settings.stiffness.memory_mb, voxel_mm);
  return voxelisedMesh(mesh, voxel_mm, progress);
}

}  // namespace lamina
