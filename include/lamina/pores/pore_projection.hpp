// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/pores/pore_groups.hpp"

namespace lamina {

/// Openings through which light falls along z: a pixel is open if no voxel of its column is solid [Vega2023,
/// section 7.2.2.5 and annex K]. Pixels of an opening are connected by edges.
struct PoreProjection {
  PoreGroups openings;  ///< in a frame of one voxel along z

  std::int64_t innerCount() const;  ///< number of openings that do not touch the border
  /// Mean diameter of discs of equal area [um], of the inner openings; 0 if there is none.
  double meanDiameterUm() const;
};

/// Whether the opening does not touch the border of the projection.
bool isInner(const PoreGroup& opening);

/// Projects a grid along z. Cost is proportional to the number of voxels over 64.
/// @param solid  cropped to the box that is to be examined
PoreProjection projectPores(const VoxelGrid& solid);

}  // namespace lamina
