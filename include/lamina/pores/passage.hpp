// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Shares of a frame's face that are reached through pores from the opposite face, along one axis [Vega2023,
/// annex J]. A path leads from a voxel to the voxel ahead in the next layer, or to one of its eight
/// neighbours there; never sideways within a layer.
struct Passage {
  double epci_forward_percent = 0.0;   ///< share of the high face that is reached from the low one
  double epci_backward_percent = 0.0;  ///< share of the low face that is reached from the high one
  /// Share of a layer that is reached from both faces; the least value over all layers.
  double mecsi_percent = 0.0;
};

/// Passages along x, y and z.
struct Passages {
  std::array<Passage, 3> along;

  double epciPercent() const;   ///< mean of three axes and two directions
  double mecsiPercent() const;  ///< mean of three axes
};

/// The passage along one axis.
/// @param pores  solid where there is a pore; beyond the frame of the grid there are no pores
/// @param axis  0 to 2
Passage passageAlong(const VoxelGrid& pores, int axis);

/// The passages along all axes, found in parallel. Cost is proportional to the voxels; memory is 2 bits per
/// voxel for each axis.
Passages passages(const VoxelGrid& pores);

}  // namespace lamina
