// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// The solid voxels that are part of a cube of solid voxels with this side; the other solid voxels belong to
/// something thinner.
/// @param side  in voxels, from 1 (all solid voxels) to 32
VoxelGrid inCubes(const VoxelGrid& grid, int side);

/// Thickness of the solid in voxels.
struct StrandThickness {
  /// The greatest side of cubes, up to `kStrandVoxels`, for which at least nine tenths of the solid voxels
  /// are part of such a cube (`inCubes`); 0 for a grid without solid voxels.
  int voxels = 0;
  double thin_share = 0.0;  ///< share of the solid voxels that are part of no cube of side `kStrandVoxels`
};

/// Least thickness of a strand, in voxels, at which finite elements of the voxels' size bend correctly.
constexpr int kStrandVoxels = 4;

StrandThickness strandThicknessOf(const VoxelGrid& grid);

}  // namespace lamina
