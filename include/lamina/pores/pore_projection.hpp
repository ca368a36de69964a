// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/pores/pore_groups.hpp"

namespace lamina {

/// Where light falls through along z: pixels are open where no voxel above them is solid
/// [Vega2023, section 7.2.2.5 and annex K]. Pixels hang together by their edges.
struct PoreProjection {
  PoreGroups openings;  ///< in a frame of one voxel along z

  std::int64_t innerCount() const;  ///< openings that do not touch the border
  /// Mean diameter of discs of equal area [um], of the inner openings; 0 if there is none.
  double meanDiameterUm() const;
};

/// Whether the opening keeps away from the border of the projection.
bool isInner(const PoreGroup& opening);

/// Cost is proportional to the voxels over 64.
/// @param solid  cropped to what is looked at
PoreProjection projectPores(const VoxelGrid& solid);

}  // namespace lamina
