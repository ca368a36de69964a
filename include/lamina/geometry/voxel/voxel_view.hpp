// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Centres of the solid voxels that have at least one face that is open or on the border of the frame [mm],
/// in order of z, y, x. Time is proportional to the words of the grid and to the number of points.
std::vector<Point3> surfaceVoxels(const VoxelGrid& grid);

/// The grid with voxels `factor` times as large, from the same corner: solid where at least half of the small
/// voxels are. What is thinner than half a large voxel may vanish, isolated voxels most of all.
/// @param factor  1 or more
VoxelGrid coarsened(const VoxelGrid& grid, int factor);

/// The `surfaceVoxels` of the grid or, if these are more than `most`, of the finest coarsened grid with at
/// most `most`.
/// @param most  1 or more
std::vector<Point3> shownVoxels(const VoxelGrid& grid, std::size_t most);

/// The `isosurface` of the grid or, if this has more than `most` triangles, of the finest coarsened grid for
/// which it has not.
/// @param most  1 or more
Mesh shownSurface(const VoxelGrid& grid, std::size_t most);

}  // namespace lamina
