// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// The voxels whose centres a closed mesh encloses. A mesh that is inside out as a whole counts as if it
/// faced outwards; overlapping bodies become one; cavities stay open. The grid begins at the low corner of
/// the bounding box of the mesh, so that a box of whole voxels is reproduced exactly.
///
/// @throws InvalidMesh   if the mesh has no triangle, or is open where a row of voxels meets it
/// @throws InvalidInput  as `voxelFrame`
/// @throws Cancelled
VoxelGrid voxelisedMesh(const Mesh& mesh, double voxel_mm, Progress& progress);

}  // namespace lamina
