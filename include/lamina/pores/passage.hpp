// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// How much of a face straight ways through pores lead to, along one axis. A way goes on from layer to layer,
/// to the voxel ahead or one of its eight neighbours, and not sideways within a layer
/// [Vega2023, annex J]. Each is a part of the face, in percent.
struct Passage {
  double epci_forward_percent = 0.0;   ///< of the high face, reached from the low one
  double epci_backward_percent = 0.0;  ///< of the low face, reached from the high one
  double mecsi_percent = 0.0;          ///< reached from both, in the layer where that is least
};

/// Passages along x, y and z.
struct Passages {
  std::array<Passage, 3> along;

  double epciPercent() const;   ///< mean of three axes and two senses
  double mecsiPercent() const;  ///< mean of three axes
};

/// @param pores  solid where there is a pore; beyond its frame there is none
/// @param axis   0 to 2
Passage passageAlong(const VoxelGrid& pores, int axis);

/// All axes, in parallel. Cost is proportional to the voxels; memory to 2 bits of them for each axis.
Passages passages(const VoxelGrid& pores);

}  // namespace lamina
