// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel_grid.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// The voxels of deposition.voxel_mm that a part fills as drawn.
/// @param part  name of a parametric part, otherwise path of a mesh file
/// @throws InvalidMesh if the mesh cannot be read or repaired; FileError; Cancelled
/// @throws InvalidInput if to compute the stiffness of so many voxels would take more memory than
///   stiffness.memory_mb: it names the voxel that would fit
VoxelGrid solidVoxels(const std::string& part, const JobSettings& settings, Progress& progress);

}  // namespace lamina
