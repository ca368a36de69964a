// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// The solid voxels that lie in a cube of solid voxels with that side: the others are of something thinner.
/// @param side  in voxels, from 1 (all that is solid) to 32
VoxelGrid inCubes(const VoxelGrid& grid, int side);

/// How many voxels thick what is solid is.
struct StrandThickness {
  /// The greatest side of cubes, up to `kStrandVoxels`, that hold nine tenths of what is solid; 0 for a grid
  /// in which nothing is.
  int voxels = 0;
  double thin_share = 0.0;  ///< of what is solid, in no cube of `kStrandVoxels`
};

/// Voxels that a strand should be thick at least, for elements of this size to bend as they should.
constexpr int kStrandVoxels = 4;

StrandThickness strandThicknessOf(const VoxelGrid& grid);

}  // namespace lamina
