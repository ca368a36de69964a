// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Middles of the solid voxels of which at least one face is open, or lies on the border of the frame [mm]:
/// by z, y, x. Cost is proportional to the words of the grid and to the points.
std::vector<Point3> surfaceVoxels(const VoxelGrid& grid);

/// The grid in cubes of `factor` voxels a side, from the same corner: solid where at least half of the
/// voxels are. What is thinner than half a cube may vanish, all the more so alone.
/// @param factor  1 or more
VoxelGrid coarsened(const VoxelGrid& grid, int factor);

/// `surfaceVoxels` of the grid, or of the finest coarser one that has no more than `most` of them.
/// @param most  1 or more
std::vector<Point3> shownVoxels(const VoxelGrid& grid, std::size_t most);

/// `isosurface` of the grid, or of the finest coarser one that has no more than `most` triangles.
/// @param most  1 or more
Mesh shownSurface(const VoxelGrid& grid, std::size_t most);

}  // namespace lamina
